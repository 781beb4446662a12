# K_I and K_II of both tips along contours.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'cells from the tip to the sides of the contour'
set ylabel 'stress intensity / (σ √(πa))'
set xrange [2.5:5.5]
set yrange [-0.9:1.9]
set xtics 1
set key top right
file = data.'/data-slope_minus_30_classic-contours.dat'
plot file using 1:8 with lines ls 1 title 'exact', \
     file using 1:9 with lines ls 1 notitle, \
     file using 1:2 with points ls 2 title 'K_I, end and start', \
     file using 1:4 with points ls 2 notitle, \
     file using 1:3 with points ls 3 title 'K_{II}, end and start', \
     file using 1:5 with points ls 3 notitle, \
     file using 1:6 with lines ls 4 dt 2 title 'interaction integral', \
     file using 1:7 with lines ls 4 dt 2 notitle
