# Stress over the radius of a cylinder that is hot along its axis.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'radius (mm)'
set ylabel 'stress over αE × rise of temperature'
set key bottom right
set xrange [0:20]
file = data.'/data-cylinder_ugimp-profile.dat'
plot file using 1:($7/1e-3) with lines ls 1 title 'exact', \
     file using 1:($9/1e-3) with lines ls 1 notitle, \
     file using 1:($8/1e-3) with lines ls 1 notitle, \
     file using 1:($3/1e-3) every 6 with points ls 2 title 'radial', \
     file using 1:($5/1e-3) every 6 with points ls 3 title 'hoop', \
     file using 1:($4/1e-3) every 6 with points ls 4 title 'axial'
