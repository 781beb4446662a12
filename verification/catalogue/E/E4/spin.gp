# Growth of the radius over the turns, APIC.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'turns'
set ylabel 'growth of the radius (%)'
set xrange [0:5]
set yrange [-9:18]
set key tmargin center horizontal maxcols 3 samplen 2.5 width -6
file(v) = data.'/data-apic_'.v.'-disk.dat'
plot 0 with lines ls 8 notitle, \
     file('musl_two_terms') using 2:(100*$3) with lines ls 3 title 'MUSL, two terms', \
     file('musl_half_step') using 2:(100*$3) with lines ls 6 title 'MUSL, two terms, half the step', \
     file('musl_one_term') using 2:(100*$3) with lines ls 1 title 'MUSL, one term', \
     file('usavg_two_terms') using 2:(100*$3) with lines ls 4 title 'USAVG, two terms', \
     file('usavg_one_term') using 2:(100*$3) with lines ls 5 title 'USAVG, one term', \
     file('usf_two_terms') using 2:(100*$3) with lines ls 2 title 'USF, two terms'
