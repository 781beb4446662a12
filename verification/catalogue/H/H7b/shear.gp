# Temperature across a block that is sheared along a held edge.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'y (m)'
set ylabel 'temperature (K)'
set xrange [0:1]
set yrange [0.1:1.05]
set key top left
plot data.'/data-shear_fine-profile.dat' using 2:4 smooth unique with lines ls 1 title 'exact', \
     data.'/data-shear_fine-profile.dat' using 2:3 every 3 with points ls 2 title 'uGIMP'
