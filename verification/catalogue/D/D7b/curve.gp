# Force over area against the opening, and the law.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'opening along the pull (mm)'
set ylabel 'force on the grip over the cone''s area (MPa)'
set xrange [0:0.06]
set yrange [0:0.12]
set key top right
file(v) = data.'/data-'.v.'-crack.dat'
plot file('up_ugimp') using 3:4 with lines ls 1 title 'law', \
     file('up_ugimp') using 3:($2/31.7543) with points ls 2 title 'ring, 30 degrees', \
     file('axis_down_classic') using 3:($2/36.9504) with points ls 3 title 'from the axis, -30 degrees'
