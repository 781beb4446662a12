# Velocity of the block against the theory's lines.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'velocity of the block (mm/ms)'
set xrange [0:25]
set yrange [-0.02:0.65]
set key tmargin center horizontal maxcols 2 samplen 2.5 width -10
file(v) = data.'/data-'.v.'-body.dat'
theory(a, t) = t > 5 ? a*(t - 2.5) : 1/0
plot theory(0.025, x) with lines ls 1 title 'theory', \
     theory(0.012009619, x) with lines ls 1 notitle, \
     theory(0, x) with lines ls 1 notitle, \
     file('rigid_frictionless') every 10 using 1:2 with points ls 2 title 'frictionless', \
     file('rigid') every 10 using 1:2 with points ls 3 title 'μ = 0.3, rigid floor', \
     file('soft') every 10::3 using 1:2 with points ls 4 title 'deformable floor', \
     file('tilted_given') every 10::5 using 1:2 with points ls 5 title 'floor turned by 30°, normal given', \
     file('tilted_soft_given') every 10::7 using 1:2 with points ls 6 title 'the same, deformable', \
     file('held') every 10 using 1:2 with points ls 7 title 'μ = 0.7', \
     file('rigid_average') using 1:2 with lines ls 6 title 'μ = 0.3, normals by average', \
     file('tilted_larger') using 1:2 with lines ls 3 title 'turned, normals by larger'
