# Speed of the centres over the gap.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'gap between the rims (mm)'
set ylabel 'speed of parting / approach'
set xrange [-0.13:0.3]
set yrange [-1.1:1.2]
set key center right
file(v) = data.'/data-'.v.'-collision.dat'
set arrow from 0, graph 0 to 0, graph 1 nohead ls 8
plot file('disks_ugimp') using 2:3 with lines ls 2 title 'disks, cells of 0.05 mm', \
     file('disks_half') using 2:3 with lines ls 3 title 'disks, 0.025 mm', \
     file('spheres_half') using 2:3 with lines ls 4 title 'spheres, 0.025 mm', \
     file('disks_shared') using 2:3 with lines ls 5 title 'disks, detection: shared'
