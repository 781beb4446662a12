# Drift of the total energy, uGIMP, enlarged.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'drift of the total energy (%)'
set xrange [0:6]
set yrange [-0.5:0.5]
set key top left
plot 0.4 with lines ls 8 notitle, -0.4 with lines ls 8 notitle, \
     0.02 with lines ls 8 dt 3 notitle, -0.02 with lines ls 8 dt 3 notitle, \
     data.'/data-ugimp_usl-energy.dat' using 1:(100*($2-1)) with lines ls 1 title 'USL', \
     data.'/data-ugimp_musl-energy.dat' using 1:(100*($2-1)) with lines ls 2 title 'MUSL', \
     data.'/data-ugimp_usf-energy.dat' using 1:(100*($2-1)) with lines ls 3 title 'USF', \
     data.'/data-ugimp_usavg-energy.dat' using 1:(100*($2-1)) with lines ls 4 title 'USAVG'
