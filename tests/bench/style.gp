# What the charts share. Colours that the colour-blind can tell apart (Okabe and Ito, 2008), and a sign
# of its own for each line, so that black and white will do.
set terminal svg size 1000,470 font "sans-serif,14" background "white"
set datafile separator ","
set datafile commentschars "#"
set border 3 lw 1.2
set tics nomirror out
set grid lc rgb "#dddddd" lw 1 dt 1
unset key
array color[4] = ["#0072B2", "#D55E00", "#009E73", "#CC79A7"]
array sign[4] = [7, 5, 9, 13]
set logscale x 10
