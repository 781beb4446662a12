# Errors over the size of the cell, cylinder.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 900,480 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set logscale xy
set xlabel 'cell / R'
set ylabel 'error (%)'
set xrange [0.027:0.145]
set yrange [0.012:8]
set xtics ('1/32' 0.03125, '1/16' 0.0625, '1/8' 0.125)
set key outside right center
file(n, q) = data.'/data-cylinder_'.n.'_levels-levels_'.q.'.dat'
plot 16*x**0.5 with lines ls 8 title 'slope 1/2', 4*x with lines ls 8 title 'slope 1', \
     file('soft', 'inside') using ($1/8):2 with linespoints ls 2 pt 6 title 'stress inside: soft', \
     file('middle', 'inside') using ($1/8):2 with linespoints ls 3 pt 6 title 'middle', \
     file('firm', 'inside') using ($1/8):2 with linespoints ls 4 pt 6 title 'firm', \
     file('soft', 'displacement') using ($1/8):2 with linespoints ls 2 pt 7 title 'displacement: soft', \
     file('middle', 'displacement') using ($1/8):2 with linespoints ls 3 pt 7 title 'middle', \
     file('firm', 'displacement') using ($1/8):2 with linespoints ls 4 pt 7 title 'firm'
