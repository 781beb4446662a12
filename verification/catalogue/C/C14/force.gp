# Tension of the contact over time, over the strength of the bars that part.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'tension / strength'
set yrange [-0.1:1.8]
set key tmargin center horizontal maxcols 3 samplen 2.5
file(v) = data.'/data-'.v.'-force.dat'
plot file('ugimp') using 1:3 with lines ls 1 title 'exact', \
     file('ugimp') using 1:2 with lines ls 2 title 'uGIMP', \
     file('ugimp_holds') using 1:(4*$2) with lines ls 3 title 'four times the strength'
