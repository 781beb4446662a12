# One quantity over another, a point for each variant: the front is joined and labelled.
# `data` has blocks: all points, then the front; the file `axes` sets ranges and labels.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel across noenhanced
set ylabel up noenhanced
unset key
load axes
set mxtics 10
plot data index 1 using 1:2 with lines lw 4 lc rgb '#b0b0b0' dt 1, \
     data index 0 using 1:2 with points pt 6 ps 0.8 lw 1.4 lc rgb '#808080', \
     data index 1 using 1:2 with points pt 7 ps 0.9 lc rgb '#0072B2'
