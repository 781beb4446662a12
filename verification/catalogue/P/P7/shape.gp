# The bar at the end, and its size over time.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 860,520 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
shape = data.'/data-ugimp_musl_coarse-shape.dat'
course = data.'/data-ugimp_musl_coarse-course.dat'
set multiplot
set origin 0.0, 0.0
set size 0.46, 1.0
set lmargin 8
set rmargin 7
set bmargin 4
set tmargin 3
set size ratio -1
set xrange [-9:9]
set yrange [0:24]
set xtics 4
set xlabel 'r (mm)'
set ylabel 'z (mm)'
set title 'plastic strain after 80 μs'
set cbrange [0:3]
set palette defined (0 '#dce6f2', 0.5 '#7fb0d8', 1.5 '#e0a040', 3 '#a02010')
unset key
plot shape using 1:2:3 with points pt 7 ps 0.32 palette, \
     shape using (-$1):2:3 with points pt 7 ps 0.32 palette
set origin 0.5, 0.0
set size noratio 0.5, 1.0
set rmargin 2
set title 'size over time'
set xrange [0:80]
set yrange [0:34]
set xtics 20
set xlabel 'time (μs)'
set ylabel 'length, radius (mm)'
set key center right
plot course using ($1*1000):3 with lines ls 2 title 'length', 21.425 with lines ls 1 title 'converged, other codes', \
     course using ($1*1000):2 with lines ls 3 title 'radius', 7.226 with lines ls 1 notitle
unset multiplot
