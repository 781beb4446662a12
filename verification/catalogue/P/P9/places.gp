# Nose and tail over time: N&G Fig. 10.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (μs)'
set ylabel 'z (mm)'
set xrange [0:60]
set yrange [-50:50]
set key bottom right
course = data.'/data-fig9-course.dat'
plot course using ($1*1e3):4 with lines ls 1 title 'Alekseevskii and Tate', \
     course using ($1*1e3):5 with lines ls 1 notitle, \
     course using ($1*1e3):6 with lines ls 1 dt 2 title 'with R = 6 GPa', \
     course using ($1*1e3):2 with lines ls 2 title 'nose', \
     course using ($1*1e3):3 with lines ls 3 title 'tail'
