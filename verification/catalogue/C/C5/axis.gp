# Axial stress on the axis over the depth.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'depth below the plate (mm)'
set ylabel 'axial stress (MPa)'
set xrange [0:15]
set yrange [-0.22:0]
set key bottom right
file(v) = data.'/data-'.v.'-axis.dat'
plot file('press_32_2') using 1:3 smooth unique with lines ls 1 title 'half-space under the pressure of Hertz', \
     file('press_16_4') using 1:2 with points ls 3 title '16 cells, 4 × 4 particles', \
     file('press_32_2') using 1:2 with points ls 2 title '32 cells, 2 × 2 particles'
