# Mean velocity of the disks, in contact and on one velocity field.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 900,480 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set xlabel 'time (µs)'
set ylabel 'mean velocity of a disk / speed of impact'
set xrange [0:40]
set yrange [0:*]
set key outside right center
c = 9.8211 # mm/µs
file(v) = data.'/data-'.v.'-chain.dat'
do for [k = 0:4] { set arrow from 60*k/c, graph 0 to 60*k/c, graph 1 nohead ls 8 }
plot for [k = 1:5] file('contact') using ($1*1e3):(column(5 + k)) with lines ls (1 + k) title sprintf('disk %d', k), \
     for [k = 1:5] file('field') using ($1*1e3):(column(5 + k)) with lines ls (1 + k) dt 2 lw 1 title (k == 5 ? 'dashed: one field' : '')
