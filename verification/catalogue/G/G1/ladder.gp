# How many problems stay bounded: methods down, Courant numbers across.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
n = words(variants)
set terminal svg size 760,130+22*n dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
unset key
set lmargin 24
set logscale x
set xlabel 'Courant number'
set xrange [0.085:3.5]
set xtics (0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1, 1.4, 2, 3)
set yrange [n+0.7:0.3]
set ytics scale 0 noenhanced
do for [i=1:n] { set ytics add (word(variants, i) i) }
set cbrange [0:6]
set cbtics 1
set cblabel 'number of problems, of six, that stay bounded'
set palette maxcolors 7 defined (0 '#67001f', 1 '#d6604d', 2 '#f4a582', 3 '#d9d9d9', 4 '#92c5de', 5 '#4393c3', 6 '#053061')
set arrow 1 from sqrt(3), graph 0 to sqrt(3), graph 1 nohead ls 8
file(i) = data.'/data-'.word(variants, i).'-ladder.dat'
plot for [i=1:n] file(i) using 1:(i):2 with points pt 7 ps 1.3 lc palette
