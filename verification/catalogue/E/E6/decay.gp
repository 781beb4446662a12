# Amplitude over time.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (periods)'
set ylabel 'amplitude over start'
set xrange [0:4]
set yrange [-1:2]
file(v) = data.'/data-'.v.'-amplitude.dat'
plot file('nodes_musl') using ($1/32):($2/1e-7) with lines ls 2 title 'one rate', \
     file('cosine_nodes_musl') using ($1/32):($2/1e-7) with lines ls 3 title 'most in the middle', \
     file('band_nodes') using ($1/32):($2/1e-7) with lines ls 4 title 'in a plane', \
     exp(-0.01*32*x) with lines ls 1 title 'exp(-a t/2)', \
     exp(-0.015*32*x) with lines ls 8 title 'exp(-3 a t/4)'
