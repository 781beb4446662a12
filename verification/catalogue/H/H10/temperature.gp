# Temperature over volume without flow of heat.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'volume V/V_0'
set ylabel 'temperature T/T_0'
set xrange [0.55:1.7]
set yrange [0.6:1.5]
set key top right
plot x**(-2.0/3) with lines ls 1 title 'exact', \
     data.'/data-adiabatic_usavg-process.dat' using 2:($3/3) every 4 with points ls 2 title 'stretched', \
     data.'/data-compressed_usavg-process.dat' using 2:($3/3) every 4 with points ls 3 title 'compressed'
