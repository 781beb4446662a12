# Energy through the collision, uGIMP.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'energy / start'
set xrange [0:3.6]
set yrange [0:1.15]
set key bottom right
file(v) = data.'/data-'.v.'-collision.dat'
plot 1 with lines ls 8 notitle, \
     file('ugimp_usl') using 1:5 with lines ls 2 title 'USL', \
     file('ugimp_musl') using 1:5 with lines ls 3 title 'MUSL', \
     file('ugimp_usavg') using 1:5 with lines ls 4 title 'USAVG', \
     file('ugimp_usavg_flip99') using 1:5 with lines ls 5 title 'USAVG, FLIP 0.99', \
     file('ugimp_usl') using 1:4 with lines ls 2 notitle, \
     file('ugimp_musl') using 1:4 with lines ls 3 notitle, \
     file('ugimp_usavg') using 1:4 with lines ls 4 notitle, \
     file('ugimp_usavg_flip99') using 1:4 with lines ls 5 notitle
