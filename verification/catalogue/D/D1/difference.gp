# How far the whole and the half are apart.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 760,560 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set xlabel 'time (ms)'
set ylabel 'largest difference in stress over the largest stress'
set logscale y
set format y '10^{%T}'
set xrange [0:45]
set yrange [1e-16:10]
set key tmargin center horizontal maxcols 2 samplen 2.5 width -10
file(v) = data.'/data-'.v.'-difference.dat'
plot file('ugimp_musl_visibility') using 1:7 with lines ls 1 title 'node visibility, uGIMP', \
     file('bspline2_musl_plain') using 1:7 with lines ls 2 title 'not reflected, quadratic splines', \
     file('ugimp_musl_plain') using 1:7 with lines ls 3 title 'not reflected, uGIMP', \
     file('classic_musl_plain') using 1:7 with lines ls 4 title 'not reflected, classic', \
     file('classic_musl') using 1:7 with lines ls 5 title 'CRAMP, classic', \
     file('ugimp_musl') using 1:7 with lines ls 6 title 'CRAMP, uGIMP', \
     file('cpdi_usavg') using 1:7 with lines ls 7 title 'CRAMP, CPDI with USAVG', \
     file('bspline2_musl') using 1:7 with lines ls 8 title 'CRAMP, quadratic splines'
