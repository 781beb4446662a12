# Errors over the cell, with the slopes of first and second order.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set logscale xy
set xlabel 'cell over side'
set ylabel 'L2 error of the displacement / L2 of the exact one'
set xrange [0.012:0.16]
set yrange [3e-4:2]
set xtics ('1/64' 1.0/64, '1/32' 1.0/32, '1/16' 1.0/16, '1/8' 1.0/8)
set format y '10^{%T}'
set key bottom right font ',12'
file(v) = data.'/data-'.v.'-levels.dat'
names = 'cpdi_usl_oneterm cpdi_usl cpdi_usavg ugimp_usl ugimp_usavg bspline3_usl'
titles = '"CPDI, USL, one term of dF" "CPDI, USL" "CPDI, USAVG" "uGIMP, USL" "uGIMP, USAVG" "cubic splines, USL"'
first = 0.125
at = 0.08
plot at*(x/first)**2 with lines ls 8 title 'slope 2', at*(x/first) with lines ls 8 dt 2 title 'slope 1', \
     for [i=1:words(names)] file(word(names,i)) using 1:3 with linespoints ls 2+(i-1)%6 title word(titles,i)
