# J of the struck crack over time, on the smallest and on the largest contour.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time since the wave has begun to arrive (ms)'
set ylabel 'J (10^{-4} N/mm)'
set xrange [0:0.046]
set yrange [0:4.8]
set key top left
file = data.'/data-ugimp-waves.dat'
plot file using 1:($2*1e4) with lines ls 1 title 'long crack, Freund', \
     file using 1:($4*1e4) every 2 with points ls 2 title '4 cells', \
     file using 1:($7*1e4) every 2 with points ls 4 title '10 cells', \
     file using 1:($8*1e4) with lines ls 3 title '4 cells, without inertia', \
     file using 1:($11*1e4) with lines ls 6 title '10 cells, without inertia'
