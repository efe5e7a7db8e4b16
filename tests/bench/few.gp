# gnuplot -c few.gp CSV SVG WHAT NAMES MACHINE: ms per picture against a small number, one line per name.
load "tests/bench/style.gp"
csv = ARG1; what = ARG3; names = ARG4
set output ARG2
stats csv using 2 every ::1 nooutput
fewest = STATS_min; most = STATS_max
stats csv using 4 every ::1 nooutput
of(name, y) = strcol(1) eq name ? y : NaN
set title sprintf("What %s cost: 800 x 600, one thread, fastest of the turns, bars to the median\n{/*0.8 %s}", what, ARG5)
set format x "%.0f"
set xlabel what
set logscale x 2
set logscale y 2
set xrange [fewest * 0.9 : most * 1.6]
set yrange [STATS_min / 1.4 : STATS_max * 1.4]
set xtics (1, 2, 3, 4, 6, 8, 12, 16, 32, 64)
set ytics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096)
set ylabel "ms per picture"
stats csv using (strcol(1) eq word(names, 1) && $2 == fewest ? $4 : NaN) every ::1 nooutput
start = STATS_min
set label 1 "in proportion" at most * 1.02, start * most / fewest left textcolor rgb "#777777"
plot sample [fewest:most] start * x / fewest with lines dt 3 lc rgb "#777777", \
    for [i = 1:words(names)] csv using 2:(of(word(names, i), $4)):4:3 every ::1 with yerrorlines lc rgb color[i] pt sign[i] ps 0.7 lw 2, \
    for [i = 1:words(names)] csv using 2:($2 == most ? of(word(names, i), $4) : NaN):(word(names, i)) every ::1 with labels left offset 1, 0.3 * (i - 2) textcolor rgb color[i]
