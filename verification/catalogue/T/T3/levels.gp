# Error of the displacement over the size of cells.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set logscale xy
set xlabel 'size of cells (mm)'
set ylabel 'error of the displacement, mean square (%)'
set xrange [0.1:1.3]
set yrange [1e-4:3]
set format y '10^{%T}'
set key bottom right
plot 0.026*x**2 with lines ls 1 title 'slope 2', 0.8*x**1.5 with lines ls 8 title 'slope 3/2', \
     data.'/data-ugimp_usl-levels_displacement.dat' using 1:2 with linespoints ls 2 title 'uGIMP, USL', \
     data.'/data-cpdi_usl-levels_displacement.dat' using 1:2 with linespoints ls 3 title 'CPDI, USL', \
     data.'/data-bspline2_usl-levels_displacement.dat' using 1:2 with linespoints ls 4 title 'quadratic splines, USL', \
     data.'/data-cpdi_usavg_pic-levels_displacement.dat' using 1:2 with linespoints ls 5 title 'CPDI, PIC', \
     data.'/data-cpdi_force-levels_displacement.dat' using 1:2 with linespoints ls 6 title 'CPDI, particle forces'
