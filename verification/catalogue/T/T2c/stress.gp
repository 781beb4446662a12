# Mean stress in the axes of the turning block.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'mean stress over the traction (%)'
set xrange [0:24]
set yrange [-20:160]
set key tmargin center horizontal maxcols 3 samplen 2.5 width -2
plot 100 with lines ls 1 title 'along, due', 0 with lines ls 8 notitle, \
     data.'/data-cpdi_usavg_apic-stress.dat' using 1:3 with lines ls 2 title 'CPDI along', \
     '' using 1:4 with lines ls 3 title 'CPDI across', \
     data.'/data-ugimp_usavg_apic-stress.dat' using 1:3 with lines ls 4 title 'uGIMP along', \
     '' using 1:4 with lines ls 5 title 'uGIMP across'
