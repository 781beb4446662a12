# Amplitude of mode 3 in its last periods, against the exact cosine.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set samples 1000
period = 2*pi/0.83024969
set xlabel 'time (periods)'
set ylabel 'amplitude of the velocity / start'
set xrange [7:10]
set yrange [-1.1:1.5]
set key top right
plot cos(2*pi*x) with lines ls 1 title 'exact', \
     data.'/data-ugimp_usavg-mode_3.dat' using ($1/period):2 with points ls 2 title 'uGIMP, USAVG, 48 cells'
