# Temperature across two slabs brought together.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'x (m)'
set ylabel 'temperature over the difference at t = 0'
set xrange [0:2]
set yrange [-0.05:1.05]
set key top right
plot data.'/data-slabs_perfect_ugimp-profile.dat' using 1:4 smooth unique with lines ls 1 title 'exact', \
     data.'/data-slabs_conductance_ugimp-profile.dat' using 1:($1<1?$4:1/0) smooth unique with lines ls 1 notitle, \
     data.'/data-slabs_conductance_ugimp-profile.dat' using 1:($1>1?$4:1/0) smooth unique with lines ls 1 notitle, \
     data.'/data-slabs_perfect_ugimp-profile.dat' using 1:3 every 3 with points ls 2 title 'perfect contact', \
     data.'/data-slabs_conductance_ugimp-profile.dat' using 1:3 every 3 with points ls 3 title 'conductance'
