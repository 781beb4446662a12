# One quantity over another, a point for each variant: colour by the order of the stress update,
# mark by the shape functions, filled on the front.
# `data` has lines `x y order shape front`; the file `axes` sets ranges, tics, labels, and the
# names of orders and shapes that
# occur, with their places among colours and marks.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 760,520 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
# verification/report/comparison_plot.c has the same inside: 0.85 of the width, 0.71 of the height
set lmargin at screen 0.13
set rmargin at screen 0.98
set bmargin at screen 0.14
set tmargin at screen 0.85
set key at screen 0.55, screen 0.985 center top horizontal maxrows 2 samplen 1 font ',12' noenhanced
set xlabel across noenhanced offset 0, 0.5
set ylabel up noenhanced offset 0.6, 0
load axes
colours = '0x808080 0xD55E00 0x0072B2 0xE69F00 0x009E73'
open_marks = '2 4 6 8 12 10'
filled_marks = '3 5 7 9 13 11'
colour(i) = int(word(colours, i + 1 > words(colours) ? 1 : i + 1))
mark(i, front) = int(word(front > 0 ? filled_marks : open_marks, i + 1 > 6 ? 1 : i + 1))
# a name without parts has neither: the key is empty
place(list, i) = i > words(list) ? 0 : int(word(list, i))
plot data using 1:2:(mark(int($4), $5)):(colour(int($3))) with points pt variable ps 0.9 lw 1.6 lc rgb variable notitle, \
     for [i=1:words(orders)] keyentry with points pt 5 ps 1.2 lc rgb colour(place(order_places, i)) title word(orders, i), \
     for [i=1:words(shapes)] keyentry with points pt mark(place(shape_places, i), 0) ps 1 lw 1.6 lc rgb '#000000' title word(shapes, i)
