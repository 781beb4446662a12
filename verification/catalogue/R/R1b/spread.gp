# Spread of J during compression, logarithmic.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'volume compression 1 - J (%)'
set ylabel 'spread of J: standard deviation over mean (%)'
set logscale y
set format y '10^{%T}'
set xrange [0:100]
set yrange [1e-5:100]
set key tmargin center horizontal maxcols 2 samplen 2.5 width -8
plot 0.01 with lines ls 8 title 'band', \
     data.'/data-consistent-curve.dat' using (100-$2):7 every ::1 with lines ls 1 title 'CPDI, one-term dF, hoop radius', \
     data.'/data-series-curve.dat' using (100-$2):7 every ::1 with lines ls 2 title 'CPDI, series dF, shape function radius', \
     data.'/data-ugimp-curve.dat' using (100-$2):7 every ::1 with lines ls 3 title 'uGIMP, one-term dF, hoop radius'
