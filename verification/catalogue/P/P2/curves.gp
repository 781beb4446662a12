# Equivalent stress over strain in a cycle.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'equivalent strain, signed (1)'
set ylabel 'equivalent stress, signed (unit of the scene)'
set yrange [-10:8]
set key bottom right
plot data.'/data-shear_perfect-path.dat' using 2:4 with lines ls 1 title 'exact', \
     data.'/data-shear_linear-path.dat' using 2:4 with lines ls 1 notitle, \
     data.'/data-shear_kinematic-path.dat' using 2:4 with lines ls 1 notitle, \
     data.'/data-shear_perfect-path.dat' using 2:3 every 2 with points ls 2 title 'perfect', \
     data.'/data-shear_linear-path.dat' using 2:3 every 2 with points ls 3 title 'linear', \
     data.'/data-shear_kinematic-path.dat' using 2:3 every 2 with points ls 4 title 'kinematic'
