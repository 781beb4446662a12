# Temperatures of particles where the vortex has taken them, and contours of the exact field.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
exact(x, y) = cos(pi*x)*cos(2*pi*y)*exp(-0.5)
set xrange [0:1]
set yrange [0:1]
set isosamples 120, 120
set contour base
set cntrparam levels discrete -0.45, -0.3, -0.15, 0, 0.15, 0.3, 0.45
unset surface
set table $contours
splot exact(x, y)
unset table
unset contour
set output output
set size ratio -1
set xlabel 'x (m)'
set ylabel 'y (m)'
set cblabel 'temperature (K)'
set palette defined (-1 '#0072B2', 0 '#F0F0F0', 1 '#D55E00')
set cbrange [-0.61:0.61]
set key outside top center horizontal
plot data.'/data-vortex_cpdi-profile.dat' using 1:2:3 with points pt 7 ps 0.45 palette title 'CPDI', \
     $contours using 1:2 with lines ls 1 title 'exact, every 0.15 K'
