# Pressure along plates that have hit their mirror images.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'x (mm)'
set ylabel 'pressure (GPa)'
set xrange [0:16]
set key tmargin center horizontal maxcols 3 samplen 2.5 width -5
file(v) = data.'/data-'.v.'-profile.dat'
plot file('tungsten_2000') using 1:(1e3*$9) with lines ls 1 title 'exact', \
     file('copper_1000') using 1:(1e3*$9) with lines ls 1 notitle, \
     file('tungsten_2000') using 1:(1e3*$4) with points ls 2 ps 0.4 title 'tungsten, 2000 m/s', \
     file('copper_1000') using 1:(1e3*$4) with points ls 3 ps 0.4 title 'copper, 1000 m/s'
