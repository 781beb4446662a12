# Error of the frequency over the cells a wavelength, without flow of heat.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'cells a wavelength'
set ylabel 'error of the frequency (%)'
set logscale xy
set xrange [14:72]
set yrange [0.08:9]
set xtics (16, 32, 64)
theory(n) = 100*(2*pi/n)**2*(1.0/24 + 3.0/32 - 0.16/24)
plot theory(x) with lines ls 1 title 'theory at given temperatures', \
     data.'/data-bar_grids-levels.dat' using (16/$1):2 with points ls 2 ps 1.4 title 'bar', \
     data.'/data-gas_grids_cpdi-levels.dat' using (16/$1):2 with points ls 3 title 'gas, CPDI'
