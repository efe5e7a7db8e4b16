# gnuplot -c cost.gp CSV SVG WHAT ENGINES MACHINE: ms per picture and Mrays/s against a number, one panel each.
load "tests/bench/style.gp"
csv = ARG1; what = ARG3; engines = ARG4
set output ARG2
stats csv using 2 every ::1 nooutput
fewest = STATS_min; most = STATS_max
of(name, y) = strcol(1) eq name ? y : NaN
at_end(name, y) = $2 == most ? of(name, y) : NaN
# The guides go through the first number of the engine that is named first.
start = NaN
stats csv using (strcol(1) eq word(engines, 1) && $2 == fewest ? $4 : NaN) every ::1 nooutput
start = STATS_min
lowest = start / 2; highest = start * 80
set format x "%.0f"
set xlabel what
set xrange [fewest * 0.8 : most * 8]
set xtics (10, 100, "1 000" 1000, "10 000" 10000, "100 000" 100000, "1 million" 1000000)
set multiplot layout 1,2 spacing 0.08,0 title sprintf("What %s cost: 800 x 600, one thread, fastest of the turns, bars to the median\n{/*0.8 %s}", what, ARG5)

set logscale y 10
set ylabel "ms per picture"
set yrange [lowest : highest]
set ytics (2, 5, 10, 20, 50, 100, 200, 500, 1000)
set label 1 "in proportion" at fewest * 28, start * 40 left textcolor rgb "#777777"
set label 2 "as the logarithm" at most * 1.1, start * log(most) / log(fewest) left textcolor rgb "#777777"
plot sample [fewest:most] start * x / fewest with lines dt 3 lc rgb "#777777", \
    [fewest:most] start * log(x) / log(fewest) with lines dt 2 lc rgb "#777777", \
    for [i = 1:words(engines)] csv using 2:(of(word(engines, i), $4)):4:3 every ::1 with yerrorlines lc rgb color[i] pt sign[i] ps 0.7 lw 2, \
    for [i = 1:words(engines)] csv using 2:(at_end(word(engines, i), $4)):(word(engines, i)) every ::1 with labels left offset 1, 0.4 * (i - 2) textcolor rgb color[i]
unset label

set ylabel "million rays per second"
set yrange [1 : 500]
set ytics (1, 2, 5, 10, 20, 50, 100, 200, 500)
plot for [i = 1:words(engines)] csv using 2:(of(word(engines, i), $6 / $4 / 1000)):($6 / $3 / 1000):($6 / $4 / 1000) every ::1 with yerrorlines lc rgb color[i] pt sign[i] ps 0.7 lw 2, \
    for [i = 1:words(engines)] csv using 2:(at_end(word(engines, i), $6 / $4 / 1000)):(word(engines, i)) every ::1 with labels left offset 1, 0.4 * (2 - i) textcolor rgb color[i]
