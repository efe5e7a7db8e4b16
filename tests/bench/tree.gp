# gnuplot -c tree.gp CSV SVG MACHINE: how many times as long a list takes as a tree.
load "tests/bench/style.gp"
csv = ARG1
set output ARG2
names = "spheres boxes mirrors"
array words_of[3] = ["spheres", "boxes", "mirroring spheres"]
set title sprintf("From how many shapes on a tree pays: 800 x 600, one thread, f32x8\n{/*0.8 %s}", ARG3)
set xlabel "shapes"
set xrange [3.5 : 700]
set xtics (4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256)
set logscale y 2
set ylabel "time by a list / time with a tree"
set yrange [0.5 : 5]
set ytics ("0.7" 0.7, "0.8" 0.8, "0.9" 0.9, 1, "1.25" 1.25, "1.5" 1.5, 2, 3, 4, 5)
set label 1 "the tree pays" at 4, 1.08 left textcolor rgb "#777777"
set label 2 "the list pays" at 4, 0.93 left textcolor rgb "#777777"
of(name, y) = strcol(2) eq name ? y : NaN
plot sample [4:256] 1 with lines lw 1.5 lc rgb "#777777", \
    for [i = 1:3] csv using 3:(of(word(names, i), $6)):7:8 every ::1 with yerrorlines lc rgb color[i] pt sign[i] ps 0.7 lw 2, \
    for [i = 1:3] csv using 3:($3 == 256 ? of(word(names, i), $6) : NaN):(words_of[i]) every ::1 with labels left offset 1, (i == 2 ? -0.6 : 0) textcolor rgb color[i]
