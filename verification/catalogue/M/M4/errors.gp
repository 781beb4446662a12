# Errors over the cell, with the slopes of first and second order.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set logscale xy
set xlabel 'cell over radius'
set ylabel 'L2 error / L2 of the exact field'
set xrange [0.012:0.16]
set yrange [5e-4:0.6]
set xtics ('1/64' 1.0/64, '1/32' 1.0/32, '1/16' 1.0/16, '1/8' 1.0/8)
set format y '10^{%T}'
set key outside right center font ',11' samplen 2.5
file(v) = data.'/data-'.v.'-levels.dat'
names = 'classic_usl ugimp_usl cpdi_usl bspline2_usl bspline3_usl'
titles = 'classic uGIMP CPDI "quadratic splines" "cubic splines"'
first = 0.125
at = 0.05
plot at*(x/first)**2 with lines ls 8 title 'slope 2', at*(x/first) with lines ls 8 dt 2 title 'slope 1', \
     for [i=1:words(names)] file(word(names,i)) using 1:3 with linespoints ls 2+(i-1)%6 title word(titles,i), \
     for [i=1:words(names)] file(word(names,i)) using 1:9 with linespoints ls 2+(i-1)%6 dt 3 title 'F, '.word(titles,i)
