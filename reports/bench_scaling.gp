# A rate against what is varied: blocks of x, median, low, high, each headed by its name.
# `label` names what is varied; `logarithmic` is 1 for an axis of powers of
# ten and 2 for one of powers of two, as many threads have no room on another.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 760,360 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set xlabel label
set ylabel 'million particle-steps / s'
set yrange [0:*]
if (logarithmic == 1) { set logscale x; set format x '10^{%T}' }
if (logarithmic == 2) { set logscale x 2 }
if (logarithmic == 0) { set xtics 1 }
set autoscale x noextend
set offsets graph 0.06, graph 0.06, graph 0.1, 0
stats data using 1 nooutput
count = STATS_blocks
if (count > 1) { set key outside right title 'particles' } else { unset key }
plot for [i = 0:count - 1] data index i using 1:2 with linespoints ls (2 + i) title columnheader(1), \
     for [i = 0:count - 1] data index i using 1:3:(0):($4 - $3) with vectors nohead ls (2 + i) \
         dt 1 lw 2.5 notitle
