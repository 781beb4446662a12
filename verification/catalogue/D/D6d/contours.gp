# Energy by J over that by the difference of energies, along contours.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'cells from the tip to the sides of the contour'
set ylabel 'integral of J dA / difference of strain energies'
set xrange [3.5:6.5]
set yrange [0.95:1.4]
set xtics 1
set key top left
file = data.'/data-up_classic-contours.dat'
plot 1 with lines ls 1 title 'difference of energies', \
     file using 1:2 with points ls 2 title 'Bergkvist and Huong', \
     file using 1:3 with points ls 3 title 'Broberg', \
     file using 1:4 with points ls 4 title 'no area term'
