# Force during an impact.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'force / (E R^2)'
set xrange [0:8]
set yrange [0:0.017]
set key top left
file(v) = data.'/data-'.v.'-contact.dat'
R = 16.0
set multiplot
plot file('impact_16_4') using 1:($5/R**2) with lines ls 1 title 'Hertz at that indentation', \
     file('impact_16_4') every 3 using 1:($3/R**2) with points ls 3 title '16 cells, 4 × 4 particles'
set origin 0.62, 0.5
set size 0.36, 0.46
unset key
set xlabel 'indentation / R'
unset ylabel
set xrange [0:0.04]
set yrange [0:*]
set xtics 0.02
set ytics 0.005
plot file('impact_16_4') using ($2/R):($5/R**2) with lines ls 1, \
     file('impact_16_4') every 3 using ($2/R):($3/R**2) with points ls 3
unset multiplot
