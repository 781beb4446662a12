# Velocity of the block against the theory's lines.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'velocity of the block (mm/ms)'
set xrange [0:25]
set yrange [-0.02:0.62]
set key top left
file(v) = data.'/data-'.v.'-block.dat'
theory(a, t) = t > 5 ? a*(t - 2.5) : 1/0
plot theory(0.025, x) with lines ls 1 title 'theory', \
     theory(0.012009619, x) with lines ls 1 notitle, \
     theory(0, x) with lines ls 1 notitle, \
     file('ugimp_frictionless') every 10 using 1:2 with points ls 2 title 'frictionless', \
     file('ugimp_usavg') every 10 using 1:2 with points ls 3 title 'μ = 0.3', \
     file('ugimp_above') every 10 using 1:2 with points ls 4 title 'μ = 0.7'
