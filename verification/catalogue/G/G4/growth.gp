# Departure of a stretched column from rest, and its growth by the linear step.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (unit of the scene)'
set ylabel 'velocity over wave speed'
set logscale y
set format y '10^{%L}'
set xrange [600:1400]
set yrange [1e-16:1e-2]
set key at 1395,3e-10 right top vertical maxrows 3 samplen 2 width -4
set clip two
plot data.'/data-cpdi_usavg-predicted.dat' using 1:2 with lines ls 8 title 'linear step', \
     data.'/data-cpdi_usavg_fifth-predicted.dat' using 1:2 with lines ls 8 notitle, \
     data.'/data-cpdi_usavg_tenth-predicted.dat' using 1:2 with lines ls 8 notitle, \
     data.'/data-cpdi_usavg-deviation.dat' using 1:2 with lines ls 1 title 'USAVG, Courant 0.4', \
     data.'/data-cpdi_usavg_fifth-deviation.dat' using 1:2 with lines ls 2 title 'Courant 0.2', \
     data.'/data-cpdi_usavg_tenth-deviation.dat' using 1:2 with lines ls 3 title 'Courant 0.1', \
     data.'/data-cpdi_usavg_once-deviation.dat' using 1:2 with lines ls 4 title 'USAVG once', \
     data.'/data-cpdi_usl-deviation.dat' using 1:2 with lines ls 5 title 'USL'
