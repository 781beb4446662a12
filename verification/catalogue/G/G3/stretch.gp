# Largest J of a bar that is pulled.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'length of the bar / start'
set ylabel 'largest J of a particle'
set xrange [1:8]
set yrange [1:4]
set key top right
shapes = 'classic ugimp cpdi bspline2 bspline3'
plot x with lines ls 1 title 'exact', \
     for [i=1:5] data.'/data-stretch_'.word(shapes, i).'-state.dat' using (1 + 0.07*$1):4 with lines ls i+1 title word(shapes, i)
