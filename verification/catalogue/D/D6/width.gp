# K_I against a/W.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
feddersen(x) = sqrt(1/cos(pi*x/2))
tada(x) = feddersen(x)*(1 - 0.025*x**2 + 0.06*x**4)
set xlabel 'a/W'
set ylabel 'K_I / σ√(πa)'
set key top left
set xrange [0:0.9]
plot tada(x) with lines ls 1 title 'Tada', \
     feddersen(x) with lines ls 3 title 'Feddersen', \
     data.'/data-plate_ugimp-contours.dat' using 2:($4*tada($2)) with points ls 2 title 'uGIMP, every contour', \
     data.'/data-plate_ugimp_13-contours.dat' using 2:($4*tada($2)) with points ls 2 notitle
