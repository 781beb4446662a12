# Density, velocity and pressure in Sod's tube.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'x (unit of the scene)'
set ylabel 'density, velocity, pressure (units of the scene)'
set yrange [-0.05:1.5]
set key tmargin center horizontal maxcols 4 samplen 2.5 width -2
file = data.'/data-sod-profile.dat'
plot file using 1:7 with lines ls 1 title 'exact', \
     file using 1:8 with lines ls 1 notitle, \
     file using 1:9 with lines ls 1 notitle, \
     file using 1:2 with points ls 2 ps 0.4 title 'density', \
     file using 1:3 with points ls 3 ps 0.4 title 'velocity', \
     file using 1:4 with points ls 4 ps 0.4 title 'pressure'
