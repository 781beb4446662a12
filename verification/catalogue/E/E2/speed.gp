# Speed of the centres through the collision.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms; of the slow disks a tenth)'
set ylabel 'speed of parting / approach'
set xrange [0:3.6]
set yrange [-1.1:1.2]
set key bottom right
file(v) = data.'/data-'.v.'-collision.dat'
plot 1 with lines ls 8 notitle, \
     file('ugimp_usavg') using 1:3 with lines ls 2 title 'cells of 0.05 mm', \
     file('ugimp_usavg_half_cells') using 1:3 with lines ls 3 title '0.025 mm', \
     file('ugimp_usavg_slow') using ($1/10):3 with lines ls 4 title '0.05 mm, a tenth of the speed'
