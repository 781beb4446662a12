# S2: approach of the axisymmetric to the planar functions.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set xlabel 'r_p / Δr'
set ylabel 'difference from the planar function (1)'
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xrange [3e2:3e9]
limit(variant) = data.'/data-'.variant.'-limit.dat'
size = 0.5
plot size**2 / 12 / x with lines ls 1 title 'l_p^2/12 over r_p/Δr', \
     size / 4 / x with lines ls 1 dt (6, 4) title 'l_p/4 over r_p/Δr', \
     limit('ugimp_truncated') using 1:3 with points ls 4 title 'uGIMP: Δr G_r, over a node', \
     limit('ugimp_truncated') using 1:2 with points ls 2 ps 1.1 title 'uGIMP: S_r, inside a cell', \
     limit('cpdi_truncated') using 1:2 with points ls 3 pt 2 title 'CPDI: S_r, inside a cell'
