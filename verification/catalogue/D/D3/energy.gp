# Energy through the collision, uGIMP.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'total energy / start'
set xrange [0:16]
set yrange [0.93:1.02]
set key bottom left
file(v) = data.'/data-'.v.'-collision.dat'
plot 1 with lines ls 8 notitle, \
     file('ugimp_usl') using 1:2 with lines ls 2 title 'USL', \
     file('ugimp_musl') using 1:2 with lines ls 3 title 'MUSL', \
     file('ugimp_usf') using 1:2 with lines ls 5 title 'USF', \
     file('ugimp_usavg') using 1:2 with lines ls 4 title 'USAVG'
