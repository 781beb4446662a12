# Error of the frequency over the cells a wavelength.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'cells a wavelength'
set ylabel 'error of the frequency (%)'
set logscale xy
set xrange [12:170]
set yrange [0.01:5]
set xtics (16, 32, 64, 128)
theory(n) = 100*(2*pi/n)**2*(1.0/24 + 3.0/32 - 0.16/24)
file(v) = data.'/data-'.v.'_usavg_four_grids-levels.dat'
plot theory(x) with lines ls 1 title 'theory, second order', 0.1 with lines ls 8 title '0.1 %', \
     file('classic') using (16/$1):2 with points ls 2 ps 1.6 title 'classic', \
     file('ugimp') using (16/$1):2 with points ls 3 title 'uGIMP', \
     file('cpdi') using (16/$1):2 with points ls 4 ps 1.2 title 'CPDI'
