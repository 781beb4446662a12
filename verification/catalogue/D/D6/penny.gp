# Penny crack: K_I by the interaction integral, and from J by both forms.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
x0 = 0.25
cylinder = (1 + x0/2 - 5*x0**2/8 + 0.421*x0**3)*sqrt(1 - x0)/(1 - x0**2)
set xlabel 'cells from the tip to the sides of the contour'
set ylabel 'K_I / 2σ√(a/π)'
set key tmargin center horizontal maxcols 3 samplen 2.5 width -6
set xrange [3.5:8.5]
set yrange [0.95:1.2]
plot cylinder with lines ls 1 title 'cylinder, handbook', \
     data.'/data-penny_ugimp-contours.dat' using 1:($4*cylinder) with linespoints ls 5 title 'interaction integral', \
     data.'/data-penny_ugimp-contours.dat' using 1:(sqrt($3)*cylinder) with linespoints ls 2 title 'J, Bergkvist and Huong', \
     data.'/data-penny_ugimp-contours.dat' using 1:(sqrt($5)*cylinder) with linespoints ls 3 title 'J, Broberg', \
     data.'/data-penny_ugimp-contours.dat' using 1:(sqrt($7)*cylinder) with linespoints ls 4 title 'J, no area term'
