# Velocity of the plug.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'velocity of the plug (mm/ms)'
set xrange [4.5:8]
set yrange [-0.02:0.4]
set key top left
file(v) = data.'/data-'.v.'-block.dat'
# until friction is overcome the plug drags the tube along: the line starts where the run is at 6 ms
stats file('friction_classic') using (abs($1 - 6) < 0.001 ? $2 : NaN) nooutput name 'C'
stats file('radius_2_classic') using (abs($1 - 6) < 0.001 ? $2 : NaN) nooutput name 'R'
plot [x=4.5:8] x < 6 ? 1/0 : C_max + 0.15*(x - 6) with lines ls 1 title 'g - 2μp/(ρR)', \
     x < 6 ? 1/0 : R_max + 0.15*(x - 6) with lines ls 1 notitle, \
     file('friction_classic') every 10 using 1:2 with points ls 2 title 'R = 4 mm, μ = 0.3', \
     file('radius_2_classic') every 10::5 using 1:2 with points ls 3 title 'R = 2 mm, μ = 0.15'
