# Throughput of every variant: two bars each, with intervals. `shown` names those of the two
# geometries (0 plane strain, 1 axisymmetric) that have bars.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 920,470 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set datafile missing '-'
set ylabel 'million particle-steps / s'
set yrange [0:*]
set autoscale x noextend
set offsets 0.2, 0.2, 0, 0
set key top right
set grid noxtics ytics
set xtics scale 0 font ',11'
# Four orders for each family of shape functions, in the data's order.
array shape_names[5] = ['classic', 'uGIMP', 'CPDI', 'B-spline 2', 'B-spline 3']
do for [s = 1:5] { set label s shape_names[s] at first 4*s - 2.5, graph -0.1 center }
array name_of[2] = ['plane strain', 'axisymmetric']
place(g) = g eq '0' ? -0.2 : 0.2
first(g) = 3 + 3 * g
plot for [g in shown] data using ($0 + place(g)):(column(first(g))):(0.38) with boxes \
         lc rgb (g eq '0' ? '#0072B2' : '#E69F00') fs pattern (g eq '0' ? 3 : 4) \
         title name_of[g + 1], \
     for [g in shown] data \
         using ($0 + place(g)):(column(first(g) + 1)):(0):(column(first(g) + 2) - column(first(g) + 1)) \
         with vectors nohead lw 2 lc rgb '#000000' notitle, \
     data using 0:(NaN):xtic(2) with points notitle
