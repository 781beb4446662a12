# Error of the stress against the distance carried.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'distance carried (cells)'
set ylabel 'error of σ_{xx}, root mean square (%)'
set logscale y
set format y '%g'
set xrange [0:100]
set yrange [0.05:1000]
set key tmargin center horizontal maxcols 3 samplen 2.5 width -4
plot 1 with lines ls 8 notitle, \
     data.'/data-classic_musl-carried.dat' using 1:2 with lines ls 3 title 'classic, MUSL', \
     data.'/data-classic_usavg-carried.dat' using 1:2 with lines ls 6 title 'classic, USAVG', \
     data.'/data-ugimp_musl-carried.dat' using 1:2 with lines ls 2 title 'uGIMP, MUSL', \
     data.'/data-ugimp_usavg-carried.dat' using 1:2 with lines ls 7 title 'uGIMP, USAVG', \
     data.'/data-cpdi_musl-carried.dat' using 1:2 with lines ls 4 title 'CPDI, MUSL', \
     data.'/data-cpdi_usavg-carried.dat' using 1:2 with lines ls 5 title 'CPDI, USAVG'
