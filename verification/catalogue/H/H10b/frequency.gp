# Error of the frequency over the cells a wavelength, without flow of heat.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'cells a wavelength'
set ylabel 'error of the frequency (%)'
set logscale xy
set xrange [28:145]
set yrange [0.02:3]
set xtics (32, 64, 128)
theory(n) = 100*(2*pi/n)**2*(1.0/24 + 3.0/32 - 0.16/24)
plot theory(x) with lines ls 1 title 'theory at given temperatures', \
     data.'/data-bar_grids-levels.dat' using (32/$1):2 with points ls 2 ps 1.4 title 'bar', \
     data.'/data-gas_grids_cpdi-levels.dat' using (32/$1):2 with points ls 3 title 'gas, CPDI', \
     data.'/data-gas_grids_bspline2-levels.dat' using (32/$1):2 with points ls 4 title 'gas, quadratic splines', \
     data.'/data-gas_grids_ugimp-levels.dat' using (32/$1):2 with points ls 5 title 'gas, uGIMP'
