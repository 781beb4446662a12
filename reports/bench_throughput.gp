# Throughput of every variant: two bars each, with intervals.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set datafile missing '-'
set style data histograms
set style histogram errorbars gap 1 lw 1
set boxwidth 0.9
set ylabel 'million particle-steps / s'
set yrange [0:*]
set key top right
set bmargin 5
unset mxtics
set grid noxtics ytics
set xtics scale 0 font ',12'
plot data using 3:4:5:xtic(sprintf("%s\n%s", strcol(2), strcol(1))) title 'plane strain' \
         fs solid 0.9 lc rgb '#0072B2', \
     '' using 6:7:8 title 'axisymmetric' fs pattern 4 lc rgb '#D55E00'
