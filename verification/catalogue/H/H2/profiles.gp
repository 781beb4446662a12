# Temperature over the radius of cylinders that are heated at their rim.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'radius r/a'
set ylabel 'temperature over that of the rim, or over q a/k'
set xrange [0:1]
set yrange [-0.05:1.05]
set key top left
plot data.'/data-cylinder_ugimp-profile.dat' using 1:4 smooth unique with lines ls 1 title 'exact', \
     data.'/data-cylinder_flux_ugimp-profile.dat' using 1:4 smooth unique with lines ls 1 notitle, \
     data.'/data-cylinder_ugimp-profile.dat' using 1:3 every 3 with points ls 2 title 'rim held', \
     data.'/data-cylinder_flux_ugimp-profile.dat' using 1:3 every 3 with points ls 3 title 'flux through the rim'
