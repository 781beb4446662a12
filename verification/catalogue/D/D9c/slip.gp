# Slip over friction, and the line through the first two.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'coefficient of friction over that of the theory'
set ylabel 'slip (% of displacements)'
set xrange [0.7:1.2]
set yrange [-1:14]
set key top right
file = data.'/data-up_classic-slip.dat'
stats file using (column(0) == 0 ? $2 : NaN) nooutput name 'L'
stats file using (column(0) == 1 ? $2 : NaN) nooutput name 'H'
set arrow from 1, -1 to 1, 14 nohead ls 1
plot L_max + (H_max - L_max)*(x - 0.8)/0.1 with lines ls 8 title 'through 0.8 and 0.9', \
     file using 1:2 with points ls 2 title 'slip, 30 degrees, classic', \
     NaN with lines ls 1 title 'theory: where it ends'
