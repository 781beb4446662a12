# Energy over 100 periods, against the decay of theory.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (periods)'
set ylabel 'total energy / start'
set xrange [0:100]
set yrange [0.2:1.1]
set key bottom left
usl = 0.001772
flip = 0.002882
file(v) = data.'/data-'.v.'-mode_1.dat'
plot file('ugimp_musl') using ($1/32):3 with lines ls 7 dt 1 lw 0.6 title 'MUSL', \
     file('ugimp_usl') using ($1/32):3 with lines ls 2 dt 1 lw 0.6 title 'USL', \
     file('ugimp_usavg') using ($1/32):3 with lines ls 4 title 'USAVG', \
     exp(-2*usl*x) with lines ls 1 title 'theory of USL', \
     exp(-2*flip*x) with lines ls 8 title 'theory of FLIP 0.99', \
     file('ugimp_usavg_flip99') every 60 using ($1/32):3 with points ls 3 title 'USAVG, FLIP 0.99'
