# CRAMP Fig. 2: stress along the mid-plane, as the nodes of a 1 mm grid see it.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
curve = data.'/data-ugimp_musl_tenth-curve.dat'
set xrange [0:100]
set multiplot layout 2,1
set ylabel 'σ_{xx} (10^{-4} MPa)'
set yrange [-1:12]
set key top right
plot curve using 1:($3*1e5) with lines ls 1 title 'eight nodes, 0.25 mm', \
     curve using 1:($4*1e5) with lines ls 3 title 'four nodes, 1 mm', \
     curve using 1:($2*1e5) with points ls 2 title 'uGIMP, 1 mm'
set ylabel 'difference (%)'
set yrange [-12:4]
set xlabel 'x (mm); the crack is left of 50'
unset key
plot curve using 1:(0) with lines ls 1, \
     curve using 1:(($4-$6)/1.3333e-6) with lines ls 3, \
     curve using 1:(($2-$3)/1.3333e-6) with points ls 2
unset multiplot
