# Force and radius of contact over the indentation, between plates.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'indentation / R'
set ylabel 'force / (E R^2)'
set y2label 'radius of contact / R'
set xrange [0:0.05]
set yrange [0:0.047]
set y2range [-0.25:0.533]
set ytics nomirror
set y2tics 0, 0.1, 0.3
set key top left
file(v) = data.'/data-'.v.'-contact.dat'
R = 16.0
plot file('press_32_2') using ($2/R):($5/R**2) with lines ls 1 title 'Hertz between plates', \
     4.0/3/(1 - 0.09)*x**1.5 with lines ls 8 title 'on a half-space', \
     file('press_16_4') every 5 using ($2/R):($3/R**2) with points ls 3 title '16 cells, 4 × 4 particles', \
     file('press_32_2') every 5 using ($2/R):($3/R**2) with points ls 2 title '32 cells, 2 × 2 particles', \
     file('press_32_2') using ($2/R):($6/R) axes x1y2 with lines ls 1 notitle, \
     file('press_16_4') every 5 using ($2/R):($4/R) axes x1y2 with points ls 3 notitle, \
     file('press_32_2') every 5 using ($2/R):($4/R) axes x1y2 with points ls 2 notitle
