# Largest J of a bar that is pulled: a panel for each family of shape functions, since all of them leave the exact line.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 760,560 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set xrange [1:8]
set yrange [1:3]
set xtics 2
set ytics 0.5
set key top right
shapes = 'classic ugimp cpdi bspline2 bspline3'
titles = 'classic uGIMP CPDI "quadratic splines" "cubic splines"'
set multiplot layout 2,3 margins 0.12, 0.97, 0.14, 0.92 spacing 0.08, 0.2
do for [i = 1:5] {
    set title word(titles, i)
    if (i % 3 == 1) { set ylabel 'largest J of a particle (1)' offset 1, 0 } else { unset ylabel }
    if (i > 2) { set xlabel 'length of the bar / start' }
    plot x with lines ls 8 title 'exact', \
         data.'/data-stretch_'.word(shapes, i).'-state.dat' using (1 + 0.07*$1):4 with lines ls i+1 dt 1 lw 1.2 notitle
}
unset multiplot
