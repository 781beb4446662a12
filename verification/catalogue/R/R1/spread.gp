# Spread of J during compression.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'volume compression 1 - J (%)'
set ylabel 'spread of J: standard deviation over mean (%)'
set xrange [0:100]
set yrange [0:20]
set key tmargin center horizontal maxcols 3 samplen 2.5 width -4
plot 15 with lines ls 8 title 'broken', \
     data.'/data-ugimp_musl-curve.dat' using (100-$2):7 with lines ls 1 title 'uGIMP, all', \
     '' using (100-$2):8 with lines ls 2 title 'uGIMP, inside', \
     data.'/data-cpdi_musl-curve.dat' using (100-$2):7 with lines ls 3 title 'CPDI, all', \
     '' using (100-$2):8 with lines ls 4 title 'CPDI, inside', \
     data.'/data-ugimp_musl_hoop-curve.dat' using (100-$2):7 with lines ls 5 title 'uGIMP, hoop radius, all', \
     data.'/data-ugimp_musl_midpoint-curve.dat' using (100-$2):7 with lines ls 6 title 'uGIMP, midpoint, all'
