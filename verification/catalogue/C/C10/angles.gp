# Error of normals over the angle of a plane to the grid.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 860,440 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
file(v) = data.'/data-'.v.'-angles.dat'
methods = 'average_2 larger_2 linear_2 logistic_2'
set xlabel 'angle of the surface to the grid (degrees)'
set xrange [-1:46]
set xtics 15
set multiplot layout 1,2
set title 'plane'
set ylabel 'error of normals, r.m.s. (degrees)'
set yrange [0:30]
set key top right
plot for [k = 1:4] file(word(methods, k)) using 1:2 with linespoints ls (k + 1) title word('average larger linear logistic', k)
set title 'edge of a block on a plane'
unset ylabel
unset key
plot for [k = 1:4] file(word(methods, k)) using 1:3 with linespoints ls (k + 1)
unset multiplot
