# Differences between two orders of materials, bodies and pairs over time.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'difference of the stress over the largest one'
set logscale y
set format y '10^{%L}'
set xrange [0:5]
set yrange [1e-17:1e-3]
set key top left
file(v) = data.'/data-ugimp_usavg_'.v.'-difference.dat'
laws = 'bonded stick frictionless friction interface mixed'
plot for [i=1:words(laws)] file(word(laws, i)) using 1:($5 > 0 ? $5 : NaN) with linespoints ls 1+i title word(laws, i), \
     1e-10 with lines ls 1 title 'limit of the check'
