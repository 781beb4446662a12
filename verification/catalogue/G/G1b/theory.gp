# Largest stable Courant number: found against predicted.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'Courant number predicted by linear theory'
set ylabel 'Courant number found by bisection'
set xrange [0.5:3]
set yrange [0.5:3]
set size square
set key top left
plot x with lines ls 1 title 'equal', \
     for [v in variants] data.'/data-'.v.'-theory.dat' using 1:2 with points ls 2 notitle, \
     NaN with points ls 2 title 'variants'
