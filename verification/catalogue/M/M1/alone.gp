# Error of the displacement when cells, steps or particles are refined alone.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set logscale xy
set xlabel 'refinement over the coarsest level'
set ylabel 'L2 error of the displacement / L2 of the exact one'
set xrange [0.11:1.15]
set xtics ('1/8' 0.125, '1/4' 0.25, '1/2' 0.5, '1' 1)
set yrange [3e-4:3]
set format y '10^{%T}'
set key tmargin center horizontal maxcols 3 samplen 2.5 width -6
file(v) = data.'/data-'.v.'-levels.dat'
plot 0.045*x**2 with lines ls 8 title 'slope 2', 0.1*x with lines ls 8 dt 2 title 'slope 1', \
     file('ugimp_usavg') using ($1*8):3 with linespoints ls 2 title 'cells and steps', \
     file('space_ugimp_usavg') using ($1*8):3 with linespoints ls 3 title 'cells alone', \
     file('time_ugimp_usavg') using ($1*80):3 with linespoints ls 4 title 'steps alone, 32 cells', \
     file('particles_ugimp_usavg') using 1:3 with linespoints ls 5 title 'particles alone, 16 cells', \
     file('at_once_ugimp_usavg') using ($1*8):3 with linespoints ls 6 title 'cells and steps, started at once'
