# Error of the stress over the cells.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'cells over the height'
set ylabel 'error of the mean stress of cells (%)'
set logscale xy
set xrange [3:40]
set yrange [0.004:4]
set xtics (4, 8, 16, 32)
file(v) = data.'/data-ugimp_'.v.'-levels_pairs.dat'
plot 100.0/16/x**2 with lines ls 1 title 'theory, particles', 500.0/16/x**2 with lines ls 8 title 'theory, nodes', \
     file('particles') using (4/$1):2 with points ls 2 title 'force at the particles', \
     file('nodes') using (4/$1):2 with points ls 3 title 'force at the nodes'
