# Force over area against opening, and the laws.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'opening (mm)'
set ylabel 'force on the grip over area (MPa)'
set xrange [0:0.09]
set yrange [0:0.11]
set key top right
file(v) = data.'/data-'.v.'-crack.dat'
plot file('ugimp_planar_linear') using 3:4 with lines ls 1 title 'laws', \
     file('ugimp_planar_trilinear') using 3:4 with lines ls 1 notitle, \
     file('ugimp_planar_exponential') using 3:4 with lines ls 1 notitle, \
     file('ugimp_planar_linear') using 3:($2/5) with points ls 2 title 'linear', \
     file('ugimp_planar_trilinear') using 3:($2/5) with points ls 3 title 'trilinear', \
     file('ugimp_planar_exponential') using 3:($2/5) with points ls 4 title 'exponential', \
     file('ugimp_radian_linear') using 3:($2/27.5) with points ls 5 title 'linear, per radian'
