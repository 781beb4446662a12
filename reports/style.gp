# Style of every figure: `load style` is the first line of a case's script.
#
# The report sets, before the script runs in the folder of the case's results:
#   style     this file
#   output    the SVG file to write
#   name      name of the figure
#   data      folder of the data files data-<variant>-<name>.dat
#   source    folder of the case's own scripts and reference data (*.gp, *.dat, *.csv)
#   variants  names of the variants that have data, separated by blanks
#   stamp     version and revision, drawn small in the corner
#   height    pixels, where 470 are too few for the legend
#
# A script looks like this:
#   load style
#   set xlabel 'r / mm'
#   set ylabel 'J'
#   plot exact(x) title 'exact' with lines ls 1, \
#        for [v in variants] data.'/data-'.v.'-j.dat' using 1:2 title v with points ls 2
#
# Line styles (colours of Okabe and Ito; each has its own dash and point type, so that no
# line is told from another by colour alone; yellow is left out, too faint on white):
#   1 black, solid: the exact curve or the reference   5 purple
#   2 blue                                             6 orange
#   3 vermillion                                       7 sky blue
#   4 green                                            8 grey, solid: limits, levels
# `variant_style(v)` gives 2 to 7 by the place of v in `variants`.
# A warning of gnuplot (a missing file, an empty range) is an error of the report.
#
# SPDX-License-Identifier: GPL-3.0-or-later

set encoding utf8
if (!exists('height')) height = 470
set terminal svg size 760,height dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output

set style line 1 lc rgb '#000000' lw 2   dt 1         pt 1  ps 0.7
set style line 2 lc rgb '#0072B2' lw 1.8 dt (12,4)    pt 6  ps 0.7
set style line 3 lc rgb '#D55E00' lw 1.8 dt (6,3)     pt 5  ps 0.6
set style line 4 lc rgb '#009E73' lw 1.8 dt (12,4,3,4) pt 9  ps 0.8
set style line 5 lc rgb '#CC79A7' lw 1.8 dt (3,3)     pt 4  ps 0.6
set style line 6 lc rgb '#E69F00' lw 1.8 dt (14,3,3,3,3,3) pt 11 ps 0.8
set style line 7 lc rgb '#56B4E9' lw 1.8 dt (8,2,2,2) pt 13 ps 0.8
set style line 8 lc rgb '#808080' lw 1.4 dt 1         pt 7  ps 0.7
set style line 20 lc rgb '#9a9a9a' lw 0.5 dt (1,3)

set border 3 lw 1
set tics nomirror out scale 0.6
set grid ls 20
set key top right noopaque samplen 3 spacing 1.15
set lmargin 11
set bmargin 4

position_of(v) = sum [i = 1:words(variants)] (word(variants, i) eq v ? i : 0)
variant_style(v) = 2 + (position_of(v) + 5) % 6

set label 9999 stamp at screen 0.995, screen 0.018 right font ',9' textcolor rgb '#808080' noenhanced
