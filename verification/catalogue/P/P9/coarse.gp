# Nose and tail over time on the coarse grid, and the rod in its crater.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 860,520 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set multiplot
set origin 0.0, 0.0
set size 0.56, 1.0
set lmargin 9
set xlabel 'time (μs)'
set ylabel 'z (mm)'
set xrange [0:30]
set yrange [-50:30]
set key bottom right
course = data.'/data-coarse-course.dat'
plot course using ($1*1e3):4 with lines ls 1 title 'Alekseevskii and Tate', \
     course using ($1*1e3):5 with lines ls 1 notitle, \
     course using ($1*1e3):2 with lines ls 2 title 'nose', \
     course using ($1*1e3):3 with lines ls 3 title 'tail'
set origin 0.56, 0.0
set size 0.44, 1.0
set size ratio -1
set lmargin 7
set rmargin 8
unset key
set xlabel 'r (mm)'
set xrange [-12:12]
set yrange [-4:44]
set xtics 6
set title 'equivalent stress (GPa)'
set cbrange [0:2]
set palette defined (0 '#dce6f2', 1 '#7fb0d8', 2 '#e0a040', 3 '#a02010')
dots = data.'/data-coarse-particles_3.dat'
plot dots using 1:2:3 with points pt 7 ps 0.4 palette, \
     dots using (-$1):($4 == 1 ? $2 : 1/0) with points pt 7 ps 0.4 lc rgb '#d0d0d0', \
     dots using (-$1):($4 == 0 ? $2 : 1/0) with points pt 7 ps 0.4 lc rgb '#303030'
unset multiplot
