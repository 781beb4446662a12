# L1 error over the size of the cells.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'cell (mm)'
set ylabel 'L1 error (%)'
set logscale xy
set xrange [0.09:2.8]
set yrange [1.5:30]
set xtics (0.125, 0.25, 0.5, 1, 2)
set ytics (2, 5, 10, 20)
set key bottom right
file(v) = data.'/data-'.v.'_five_grids-levels.dat'
plot 4.2*(x/0.125)**0.5 with lines ls 8 title 'slope 1/2', \
     2.46*(x/0.125)**(2.0/3) with lines ls 8 dt 2 title 'slope 2/3', \
     file('ugimp_usavg') using (2*$1):2 with points ls 2 title 'uGIMP, USAVG', \
     file('classic_usavg') using (2*$1):2 with points ls 3 title 'classic, USAVG', \
     file('ugimp_usavg_flip99') using (2*$1):2 with points ls 4 title 'uGIMP, USAVG, FLIP 0.99'
