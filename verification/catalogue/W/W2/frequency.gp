# Error of three frequencies over the number of cells.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'cells over the radius'
set ylabel 'error of the frequency (%)'
set logscale xy
set xrange [9:130]
set yrange [1e-4:20]
set xtics (12, 24, 48, 96)
set format y '10^{%T}'
set key bottom left
file(v, m) = data.'/data-'.v.'_usavg_four_grids-levels_'.m.'.dat'
second(n, at96) = at96*(96.0/n)**2
plot 0.5 with lines ls 8 dt 2 title '0.5 %', \
     for [e in '0.000527 0.0295 0.08573'] second(x, real(e)) with lines ls 8 lw 0.8 notitle, \
     for [m=1:3] file('ugimp', m) using (12/$1):2 with points ls m+1 pt 7 title 'mode '.m.', uGIMP', \
     for [m=1:3] file('classic', m) using (12/$1):2 with points ls m+1 pt 6 ps 1.4 title 'mode '.m.', classic'
