# Errors over the cell, with the slopes of first and second order.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set logscale xy
set xlabel 'cell over width of the ring'
set ylabel 'L2 error of the displacement / L2 of the exact one'
set xrange [0.025:0.4]
set yrange [1e-6:0.1]
set xtics ('1/32' 1.0/32, '1/16' 1.0/16, '1/8' 1.0/8, '1/4' 0.25)
set format y '10^{%T}'
set key bottom right font ',12'
file(v) = data.'/data-'.v.'-levels.dat'
names = 'cpdi_usl aligned_small_ugimp_usavg aligned_small_cpdi_usavg aligned_small_bspline2_usl'
titles = '"faces across the grid, CPDI" "on grid lines, uGIMP" "on grid lines, CPDI" "on grid lines, quadratic splines"'
first = 0.25
at = 0.01
plot at*(x/first)**2 with lines ls 8 title 'slope 2', at*(x/first) with lines ls 8 dt 2 title 'slope 1', \
     for [i=1:words(names)] file(word(names,i)) using 1:3 with linespoints ls 2+(i-1)%6 title word(titles,i)
