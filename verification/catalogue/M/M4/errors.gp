# Errors of displacement and F over the cell, with the slopes of first and second order. The legend is a plot of its own
# below both panels.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 760,520 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set logscale xy
set xlabel 'cell over radius'
set ylabel 'L2 error / L2 of the exact field'
set xrange [0.012:0.16]
set yrange [5e-4:0.6]
set xtics ('1/64' 1.0/64, '1/32' 1.0/32, '1/16' 1.0/16, '1/8' 1.0/8)
set format y '10^{%T}'
file(v) = data.'/data-'.v.'-levels.dat'
names = 'classic_usl ugimp_usl cpdi_usl bspline2_usl bspline3_usl'
titles = 'classic uGIMP CPDI "quadratic splines" "cubic splines"'
first = 0.125
at = 0.05
unset key
set tmargin at screen 0.9
set bmargin at screen 0.30
set multiplot
do for [k = 1:2] {
    set lmargin at screen (k == 1 ? 0.11 : 0.6)
    set rmargin at screen (k == 1 ? 0.48 : 0.97)
    set title word('displacement "deformation gradient F"', k)
    plot at*(x/first)**2 with lines ls 8, at*(x/first) with lines ls 8 dt 2, \
         for [i=1:words(names)] file(word(names,i)) using 1:(column(k == 1 ? 3 : 9)) with linespoints ls 2+(i-1)%6
    unset ylabel
}
unset title
unset xlabel
unset border
unset tics
unset grid
set tmargin at screen 0.15
set bmargin at screen 0.03
set lmargin at screen 0.05
set rmargin at screen 0.97
set key center horizontal maxcols 4 samplen 2.5
plot NaN with lines ls 8 title 'slope 2', NaN with lines ls 8 dt 2 title 'slope 1', \
     for [i=1:words(names)] NaN with linespoints ls 2+(i-1)%6 title word(titles,i)
unset multiplot
