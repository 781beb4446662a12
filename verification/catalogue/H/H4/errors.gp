# Error over the relative size of the cells.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set logscale xy
set xlabel 'cell size over that of the coarsest grid, h/h_1'
set xtics ('1/4' 0.25, '1/2' 0.5, '1' 1)
set ylabel 'error of temperature (% of the amplitude)'
set xrange [0.2:1.2]
set yrange [0.02:4]
set key bottom right
plot 2*x**2 with lines ls 8 title 'second order', \
     data.'/data-ugimp-levels_l2.dat' using 1:2 with linespoints ls 2 title 'uGIMP'
