# Distance of the cracks' faces over time.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set ylabel 'distance of the faces (mm)'
set xrange [0:16]
set yrange [-4:3]
set key tmargin center horizontal maxcols 3 samplen 2.5 width -6
file(v) = data.'/data-'.v.'-collision.dat'
plot 0 with lines ls 8 notitle, \
     file('ugimp_usavg') using 1:5 with lines ls 2 dt 1 title 'left crack, widest', \
     file('ugimp_usavg') using 1:6 with lines ls 2 dt (6,3) title 'left, narrowest', \
     file('ugimp_usavg') using 1:7 with lines ls 3 dt 1 title 'right crack, widest', \
     file('ugimp_usavg') using 1:8 with lines ls 3 dt (6,3) title 'right, narrowest', \
     file('ugimp_usavg_none') using 1:6 with lines ls 2 dt (2,3) title 'left, narrowest, no contact', \
     file('ugimp_usavg_none') using 1:8 with lines ls 3 dt (2,3) title 'right, narrowest, no contact'
