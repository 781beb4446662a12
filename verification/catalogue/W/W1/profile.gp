# Pressure along the bar against the exact step and its dispersion.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'x (mm)'
set ylabel 'pressure / ρcV'
set xrange [0:90]
set yrange [-0.1:1.45]
set key bottom left
file(v) = data.'/data-'.v.'-profile.dat'
plot file('ugimp_usavg') using 1:3 with lines ls 1 title 'exact', \
     file('ugimp_usavg') using 1:4 with lines ls 8 title 'exact, dispersed (long waves)', \
     file('ugimp_usavg') using 1:2 with points ls 2 ps 0.5 title 'uGIMP, USAVG', \
     file('ugimp_usl') using 1:2 with lines ls 3 title 'uGIMP, USL'
