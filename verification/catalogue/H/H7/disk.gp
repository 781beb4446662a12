# Temperature of a disk after a quarter of a turn, and along what was the x axis.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 900,460 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
empty = -1e29
set multiplot layout 1,2 margins 0.07, 0.98, 0.15, 0.92 spacing 0.2, 0
set size ratio -1
set tics scale 0.4
set xlabel 'x (m)'
set ylabel 'y (m)'
set xrange [0:4]
set yrange [0:3.5]
unset key
unset grid
set palette defined (300 '#eef4fb', 315 '#9ecae1', 330 '#0072B2', 350 '#D55E00')
set cbrange [300:350]
set title 'temperature (K)'
plot data.'/data-fine-temperature.dat' matrix using (($1 + 0.5)*0.02):(($2 + 0.5)*0.02):($3 < empty ? NaN : $3) with image
set size noratio
unset title
set xlabel 'x at t = 0, from the middle (m)'
set ylabel 'temperature (K)'
set xrange [-1:1]
set yrange [295:445]
set key on inside top left samplen 1 font ',11'
set grid
file(v) = data.'/data-'.v.'-profile.dat'
cut(y, t) = abs(y - 1.375) < 0.02 ? t : NaN
coarse(y, t) = abs(y - 1.375) < 0.04 ? t : NaN
plot 300 + 100*exp(-(x - 0.375)**2/0.0225) with lines ls 8 title 'at t = 0', \
     file('fine') using ($5 - 1.375):(cut($6, $4)) smooth unique with lines ls 1 title 'exact', \
     file('fine') using ($5 - 1.375):(cut($6, $3)) with points ls 2 title 'FLIP', \
     file('pic_ugimp') using ($5 - 1.375):(coarse($6, $3)) with points ls 3 title 'PIC alone, 20 steps'
unset multiplot
