# Error against processor time: a line for each variant, the Pareto front over all.
# `blocks` names the data's blocks, shape and order, or change, as digits (11 is classic USL); the front
# is the block after them. `label` names the error.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 760,600 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set logscale xy
set xlabel 'processor time of the steps (s)'
set ylabel label
set format xy '10^{%T}'
set mxtics 10
set yrange [*:200]
set autoscale x noextend
set offsets graph 0.04, graph 0.04, 0, 0
unset bmargin
set key outside bottom center horizontal maxcols 5 samplen 2.5 height 1 width -1

array shape_names[5] = ['classic', 'uGIMP', 'CPDI', 'B-spline 2', 'B-spline 3']
array order_names[9] = ['USL', 'MUSL', 'USF', 'USAVG', 'APIC', 'XPIC(2)', 'FMPM(2)', 'FLIP 0.99', 'momentum form']
array marker[9] = [6, 4, 8, 12, 1, 2, 3, 10, 14]
shape_of(i) = int(word(blocks, i)[1:1])
order_of(i) = int(word(blocks, i)[2:2])
count = words(blocks)

plot data index count using 1:2 with steps lw 5 lc rgb '#b0b0b0' dt 1 title 'Pareto front', \
     for [i = 1:count] data index (i - 1) using 1:2 with linespoints ls (1 + shape_of(i)) lw 1 \
         pt marker[order_of(i)] ps 0.8 notitle, \
     for [s = 1:5] NaN with lines ls (1 + s) lw 1.6 title shape_names[s], \
     for [o = 1:9] NaN with points pt marker[o] ps 0.9 lc rgb '#000000' title order_names[o]
