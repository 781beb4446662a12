# Angle over time, APIC and FLIP.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (turns of the start)'
set ylabel 'turns'
set xrange [0:5]
set yrange [0:5]
set key top left
turn = 2*pi/0.0145
file(v) = data.'/data-'.v.'-disk.dat'
plot x with lines ls 1 title 'rigid', \
     file('apic_musl_one_term') using ($1/turn):2 with lines ls 4 title 'APIC, MUSL, one term', \
     file('apic_usavg_two_terms') using ($1/turn):2 with lines ls 5 title 'APIC, USAVG', \
     file('ugimp_usavg_half_cells') using ($1/turn):2 with lines ls 2 title 'FLIP, USAVG, 8 cells', \
     file('ugimp_usavg') using ($1/turn):2 with lines ls 3 title 'FLIP, USAVG, 4 cells'
