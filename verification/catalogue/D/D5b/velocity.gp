# Velocity of the block along its crack.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'velocity along the crack (mm/ms)'
set xrange [0:25]
set yrange [-0.02:0.32]
set key top left
file(v) = data.'/data-'.v.'-block.dat'
theory(a, t) = t < 5 ? 0.5*a*(t - 5/pi*sin(pi*t/5)) : a*(t - 2.5)
plot theory(0.012009619, x) with lines ls 1 title 'theory', \
     theory(0, x) with lines ls 1 notitle, \
     file('tilt_20_friction') every 10 using 1:2 with points ls 2 title 'μ = 0.3, at 20 degrees', \
     file('tilt_65_above') every 10 using 1:2 with points ls 3 title 'μ = 0.7, at 65 degrees'
