# Mean radial stress against relative volume, logarithmic in both.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'relative volume J (%)'
set ylabel '- mean σ_{rr} (MPa)'
set logscale xy
set xrange [100:0.15]
set yrange [10:1e8]
set format y '10^{%T}'
set key top left
plot data.'/data-consistent-curve.dat' using 2:(-$5) with lines ls 1 dt 2 title 'exact (66)', \
     '' using 2:(-$3) every 15 with points ls 2 title 'CPDI, one-term dF, hoop radius', \
     data.'/data-series-curve.dat' using 2:(-$3) every 15::7 with points ls 3 title 'CPDI, series dF, shape function radius'
