# Smallest and largest J over the exact one.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'exact relative volume J'
set ylabel 'J of a particle / exact'
set logscale x
set xrange [1:0.049]
set xtics (1, 0.5, 0.2, 0.1, 0.05)
set yrange [0.8:2]
set key tmargin center horizontal maxcols 5 samplen 2.5 width -2
exact(p) = (1 - 0.0077639320225*p)**2
shapes = 'classic ugimp cpdi bspline2 bspline3'
file(s) = data.'/data-compress_'.s.'-state.dat'
plot 1 with lines ls 8 notitle, \
     for [i=1:5] file(word(shapes, i)) using (exact($1)):($4/exact($1)) with lines ls i+1 title word(shapes, i), \
     for [i=1:5] file(word(shapes, i)) using (exact($1)):($3/exact($1)) with lines ls i+1 notitle
