# Velocity of the disk and of its rim against the theory's lines.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'velocity, spin × radius (mm/ms)'
set xrange [0:45]
set yrange [-0.02:1.4]
set key tmargin center horizontal maxcols 2 samplen 2.5 width -9 font ',12'
file(v) = data.'/data-'.v.'-body.dat'
g = 0.05/sqrt(2)
theory(a, t) = t > 15 ? a*(t - 7.5) : 1/0
plot theory(2*g/3, x) with lines ls 1 title 'theory', \
     theory(g*0.75, x) with lines ls 1 notitle, \
     theory(2*0.25*g, x) with lines ls 1 notitle, \
     file('rolls_4') every 10 using 1:2 with points ls 2 title 'rolls, μ = 0.5: velocity', \
     file('rolls_4') every 10 using 1:($4*8) with points ls 3 title 'rolls: spin × radius', \
     file('slips_4') every 10 using 1:2 with points ls 4 title 'slips, μ = 0.25: velocity', \
     file('slips_4') every 10 using 1:($4*8) with points ls 5 title 'slips: spin × radius', \
     file('tilted_slips_given_4') every 10 using 1:2 with lines ls 6 title 'slips on a turned floor: velocity', \
     file('tilted_slips_given_4') every 10 using 1:($4*8) with lines ls 7 title 'turned floor: spin × radius'
