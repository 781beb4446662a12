# Speed of the centres through the collision.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'speed of parting / approach'
set xrange [0:12]
set yrange [-1.1:1.2]
set key bottom right
file(v) = data.'/data-'.v.'-collision.dat'
set arrow from 2, graph 0 to 2, graph 1 nohead ls 8
plot file('contact') using 1:3 with lines ls 2 title 'contact', \
     file('field') using 1:3 with lines ls 3 title 'one velocity field'
