# Differences of the stress between bodies in contact and one body.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time over the end'
set ylabel 'difference of the stress over the largest one'
set logscale y
set format y '10^{%L}'
set yrange [1e-16:1]
set key center right
file(v) = data.'/data-'.v.'-difference.dat'
plot file('ugimp_usavg') using ($1/24):5 with lines ls 1 title 'bonded', \
     file('ugimp_usavg_pressed') using 1:5 with linespoints ls 2 title 'pressed, stick, areas', \
     file('ugimp_usavg_extent') using 1:5 with linespoints ls 3 title 'pressed, stick, gap'
