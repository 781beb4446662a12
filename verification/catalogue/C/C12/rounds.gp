# Ratio of processor times, round by round.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'round'
set ylabel 'time with contact / time without'
set xrange [0:31]
set yrange [0.9:1.5]
set key top right
file(v) = data.'/data-'.v.'-rounds.dat'
plot 1 with lines ls 1 title 'without contact', \
     1.05 with lines ls 1 dashtype 2 title 'goal', \
     file('frictionless_timed') using 1:2 with linespoints ls 2 title 'frictionless', \
     file('friction_timed') using 1:2 with linespoints ls 3 title 'friction', \
     file('shared_timed') using 1:2 with linespoints ls 4 title 'friction, detection: shared', \
     file('logistic_timed') using 1:2 with linespoints ls 5 title 'friction, normal: logistic'
