# S1: largest error by region of samples.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 760,560 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set tmargin 6
set xlabel 'region of the samples'
set ylabel 'largest |code − reference| (1)'
set logscale y
set format y '10^{%L}'
set yrange [1e-17:1e-10]
set xrange [-0.5:4.5]
set xtics ('near' 0, 'grid lines' 1, 'axis' 2, 'far, exact' 3, 'far, any' 4)
set key tmargin center horizontal maxcols 5 samplen 2.5 width -6
shapes = 'classic ugimp cpdi bspline2 bspline3'
planes = 'planar truncated untruncated'
markers = '4 6 8' # one for each plane; one colour for each family
shape(i) = 1 + (i - 1) / 3
plane(i) = 1 + (i - 1) % 3
errors(i) = data.'/data-'.word(shapes, shape(i)).'_'.word(planes, plane(i)).'-errors.dat'
larger(a, b) = a > b ? a : b
# An error of exactly zero (positions exact in cells) is drawn on the lower edge, one that is not a
# number on the upper one.
drawn(value) = value == value ? larger(1e-17, value) : 1e-10
error(a, b, c, d) = drawn(a + b + c + d == a + b + c + d ? larger(larger(a, b), larger(c, d)) : NaN)
place(region, i) = region + 0.05 * (i - 8)
plot 1e-12 with lines ls 1 dt (6, 4) title 'criterion', \
     2e-11 with lines ls 20 lw 2 dt (6, 4) title 'criterion (far, any)', \
     for [i = 1:15] errors(i) using (place($1, i)):(error($2, $3, $4, $5)) with points \
         ls shape(i) pt int(word(markers, plane(i))) ps 0.9 notitle, \
     for [i = 4:15] errors(i) using (place($1, i)):(drawn($6)) with points ls 20 pt '–' \
         title (i == 4 ? 'bound by GSL' : ''), \
     for [i = 1:5] keyentry with points ls i pt 5 ps 1.1 title word(shapes, i), \
     for [i = 1:3] keyentry with points ls 1 pt int(word(markers, i)) ps 0.9 title word(planes, i)
