# Error over the relative size of the cells.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set logscale xy
set xlabel 'cell size over that of the coarsest grid, h/h_1'
set xtics ('1/4' 0.25, '1/2' 0.5, '1' 1)
set ylabel 'error of temperature (% of the amplitude)'
set xrange [0.2:1.2]
set yrange [0.1:20]
set key bottom right
file(v) = data.'/data-'.v.'-levels_l2.dat'
plot 3*x**2 with lines ls 8 title 'second order', \
     file('square_ugimp') using 1:2 with linespoints ls 2 title 'at rest: square, uGIMP', \
     file('cylinder_ugimp') using 1:2 with linespoints ls 3 title 'cylinder, uGIMP', \
     file('square_bspline2') using 1:2 with linespoints ls 4 title 'square, quadratic splines', \
     file('vortex_cpdi') using 1:2 with linespoints ls 5 title 'deforming: square, CPDI', \
     file('vortex_ugimp') using 1:2 with linespoints ls 6 title 'square, uGIMP', \
     file('ring_bspline3') using 1:2 with linespoints ls 7 title 'cylinder, cubic splines'
