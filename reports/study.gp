# Errors of a convergence study, mpm-verify study: a curve for each variant.
#
# Beside what style.gp lists: data (file of blocks), across and up (labels), curves (how many blocks
# are curves), slopes (1: one more block has triangles of slopes 1 and 2), axes (ranges and labels).
#
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set logscale xy
load axes
set xlabel across
set ylabel up
set format y '%.0e'
set key above center horizontal noenhanced
if (slopes) {
    plot for [i=0:curves-1] data index i using 1:2 title columnheader(1) \
             with linespoints ls 2+i%6 pt 4+i, \
         data index curves using 1:2 notitle with lines ls 8
} else {
    plot for [i=0:curves-1] data index i using 1:2 title columnheader(1) \
             with linespoints ls 2+i%6 pt 4+i
}
