# Temperature in a slab with tables, steady and with a flux.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'place in the slab (m)'
set ylabel 'temperature (K)'
set xrange [0:1]
set yrange [0:110]
set key top left
plot data.'/data-steady_ugimp-profile.dat' using 1:4 smooth unique with lines ls 1 title 'exact', \
     data.'/data-steady_ugimp-profile.dat' using 1:3 every 3 with points ls 2 title 'steady', \
     data.'/data-flux_ugimp-profile.dat' using 1:4 smooth unique with lines ls 1 notitle, \
     data.'/data-flux_ugimp-profile.dat' using 1:3 every 3 with points ls 3 title 'with a flux'
