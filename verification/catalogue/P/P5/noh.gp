# Density and internal energy of a cold gas that has hit a wall.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'x (unit of the scene)'
set ylabel 'density, 4 times the internal energy'
set xrange [0:0.3]
set yrange [0:5]
set key top right
file = data.'/data-noh-profile.dat'
plot file using 1:7 with lines ls 1 title 'exact', \
     file using 1:(4*$10) with lines ls 1 notitle, \
     file using 1:2 with points ls 2 ps 0.4 title 'density', \
     file using 1:(4*$5) with points ls 3 ps 0.4 title '4 e'
