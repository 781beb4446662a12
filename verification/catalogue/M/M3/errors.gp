# Errors over the cell, with the slopes of first and second order.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set logscale xy
set xlabel 'cell over width of the ring'
set ylabel 'L2 error of the displacement / L2 of the exact one'
set xrange [0.025:0.4]
set yrange [1e-3:0.6]
set xtics ('1/32' 1.0/32, '1/16' 1.0/16, '1/8' 1.0/8, '1/4' 0.25)
set format y '10^{%T}'
set key bottom right font ',12'
file(v) = data.'/data-'.v.'-levels.dat'
names = 'cpdi_usl bspline3_usl ugimp_usl inside_ugimp_usavg inside_bspline2_usl'
titles = '"CPDI, USL" "cubic splines, USL" "uGIMP, USL" "inside: uGIMP, USAVG" "inside: quadratic splines, USL"'
first = 0.25
at = 0.2
plot at*(x/first)**2 with lines ls 8 title 'slope 2', at*(x/first) with lines ls 8 dt 2 title 'slope 1', \
     for [i=1:words(names)] file(word(names,i)) using 1:3 with linespoints ls 2+(i-1)%6 title word(titles,i)
