# Temperature over the distance from the centre: a flux, a prescribed surface, a mode.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'distance from the centre / a'
set ylabel 'temperature over its scale'
set xrange [0:1.02]
set yrange [-0.02:1.05]
set key top left
file(v) = data.'/data-'.v.'-profile.dat'
rho(x, y) = sqrt(x*x + y*y)
plot file('held_ugimp') using (rho($1, $2)):4 smooth unique with lines ls 1 title 'exact', \
     file('flux_ugimp') using (rho($1, $2)):4 smooth unique with lines ls 1 notitle, \
     file('mode_ugimp') using (rho($1, $2)):4 smooth unique with lines ls 1 notitle, \
     file('held_ugimp') using (rho($1, $2)):3 every 11 with points ls 2 title 'surface held, 16 cells', \
     file('flux_ugimp') using (rho($1, $2)):3 every 41 with points ls 3 title 'flux, 32 cells', \
     file('mode_ugimp') using (rho($1, $2)):3 every 97 with points ls 4 title 'mode in a cylinder of 0.6 a, 32 cells'
