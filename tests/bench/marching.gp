# gnuplot -c marching.gp FOLDER MACHINE: steps to a plane, the price of normals, and what footprints cost.
load "tests/bench/style.gp"
folder = ARG1
of(name, y) = strcol(1) eq name ? y : NaN
second(name, y) = strcol(2) eq name ? y : NaN

array ways[4] = ["1", "1.2", "1.6", "slope"]
array way_names[4] = ["as long as allowed", "1.2 times", "1.6 times", "by the slope"]
csv = folder."/march-steps.csv"
set output "doc/march-steps.svg"
set title sprintf("Steps of a ray from height 1 to a plane, tolerance 2e-3 to 1e-4\n{/*0.8 %s}", ARG2)
set xlabel "angle between ray and plane, degrees"
set ylabel "steps"
set logscale y 10
set xrange [0.08 : 120]
set yrange [3 : 10000]
plot csv using 2:(of("1", $4)) every ::1 with lines lw 1.5 dt 2 lc rgb "#777777", \
    for [i = 1:4] csv using 2:(of(ways[i], $3)) every ::1 with linespoints lc rgb color[i] pt sign[i] ps 0.7 lw 2, \
    for [i = 1:4] csv using 2:($2 == 30 ? of(ways[i], $3) : NaN):(way_names[i]) every ::1 with labels left offset 1, (i == 1 ? 0.3 : i == 2 ? -0.3 : i == 3 ? 0.6 : -1) textcolor rgb color[i]

array kinds[4] = ["exact", "central", "forward", "tetrahedron"]
csv = folder."/march-normals.csv"
set output "doc/march-normals.svg"
set title sprintf("Normals of a ring, f32x1: error against cost, for differences of 1e-1 to 1e-6\n{/*0.8 %s}", ARG2)
set xlabel "nanoseconds a normal"
set ylabel "worst error, radians"
set xrange [5 : 200]
set yrange [1e-7 : 5]
set format y "%.0e"
ring(name, y) = strcol(1) eq "ring" && strcol(2) eq name ? y : NaN
plot for [i = 1:4] csv using 4:(ring(kinds[i], $5)) every ::1 with points lc rgb color[i] pt sign[i] ps 0.9, \
    for [i = 1:4] csv using 4:(abs($3 - (i == 1 ? 0 : 0.1)) < 1e-3 ? ring(kinds[i], $5) : NaN):(kinds[i]) every ::1 with labels left offset 1, 0.6 textcolor rgb color[i]

csv = folder."/marching.csv"
array scenes[4] = ["scenes/endless-frames.lua", "scenes/melting.lua", "scenes/menger-sponge.lua", "scenes/cube-frame.lua"]
array scene_names[4] = ["endless frames", "melting", "Menger sponge", "cube frame"]
set output "doc/march-footprint.svg"
set title sprintf("What a footprint costs: f32x8, 800 x 600\n{/*0.8 %s}", ARG2)
set xlabel "footprint, shares of half a pixel"
set ylabel "pixels off by more than one step, %"
set format y "%g"
set xrange [0.02 : 2]
set yrange [0.003 : 10]
set xtics ("1/32" 0.03125, "1/16" 0.0625, "1/8" 0.125, "1/4" 0.25, "1/2" 0.5)
foot(name, y) = strcol(1) eq name && strcol(2) eq "footprint" ? y : NaN
plot for [i = 1:4] csv using 3:(foot(scenes[i], $5)) every ::1 with linespoints lc rgb color[i] pt sign[i] ps 0.7 lw 2, \
    for [i = 1:4] csv using 3:($3 == 0.5 ? foot(scenes[i], $5) : NaN):(scene_names[i]) every ::1 with labels left offset 1, 0 textcolor rgb color[i]
