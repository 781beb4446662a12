# Temperature along a rod that moves through a held place.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'x (m)'
set ylabel 'temperature (K)'
set xrange [-1:1]
set yrange [0.1:1.05]
set key top left
file(v) = data.'/data-'.v.'-profile.dat'
plot file('rod_ugimp') using 1:4 smooth unique with lines ls 1 title 'exact', \
     file('rod_ugimp') using 1:3 every 2 with points ls 2 title 'uGIMP', \
     file('rod_bspline2') using 1:3 every 2 with points ls 3 title 'quadratic splines'
