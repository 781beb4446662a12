# Temperature over the run, as a part of it.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time over that of the run'
set ylabel 'change of temperature (K)'
set xrange [0:1]
set yrange [0:160]
set key top left
tungsten = data.'/data-tungsten-course.dat'
copper = data.'/data-copper-course.dat'
plot tungsten using ($1/0.01):($7 - 300) with lines ls 1 title 'exact', \
     copper using ($1/0.005):($7 - 298) with lines ls 1 notitle, \
     tungsten using ($1/0.01):($4 - 300) every 20 with points ls 2 title 'tungsten, compressed by 26 %', \
     copper using ($1/0.005):($4 - 298) every 10 with points ls 3 title 'copper, strain 0.58'
