# Error of the stress over the initial height.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'initial height Y (m)'
set ylabel 'error of σ_{yy} over its value at the foot (%)'
set xrange [0:50]
set yrange [-2:2]
set key top right
plot data.'/data-ugimp_usavg-profile.dat' using 2:(($4-$8)/400) with points ls 2 title 'uGIMP', \
     data.'/data-cpdi_usavg-profile.dat' using 2:(($4-$8)/400) with points ls 3 title 'CPDI', \
     0.195 with lines ls 8 title 'a quarter of a cell', -0.195 with lines ls 8 notitle
