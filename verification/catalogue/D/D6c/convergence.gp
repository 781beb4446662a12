# Errors of J, K_I and K_II over the cell size.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'cell (mm)'
set ylabel 'error (%)'
set xrange [0:1.1]
set yrange [-0.5:4.5]
set key top left
file(k) = data.'/data-up_ugimp'.(k == 1 ? '' : '_'.k).'-errors.dat'
plot 3.7*x with lines ls 1 title 'first order', \
     2.5*x with lines ls 1 notitle, \
     for [k=1:4] file(k) using (1.0/k):1 with points ls 2 title (k == 1 ? 'J' : ''), \
     for [k=1:4] file(k) using (1.0/k):2 with points ls 3 title (k == 1 ? 'K_I, solver' : ''), \
     for [k=1:4] file(k) using (1.0/k):3 with points ls 4 title (k == 1 ? 'K_{II}, solver' : '')
