# Displacement along the laminate; the interface is the jump.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'place along the laminate (mm)'
set ylabel 'displacement (10^{-6} mm)'
set xrange [0:16]
set yrange [-130:300]
set key top left
file(v) = data.'/data-'.v.'-displacement.dat'
names = 'ugimp_usavg ugimp_usavg_pic ugimp_usavg_stiff ugimp_compression'
titles = '"D = 0.25 kPa/mm, tension" "the same, PIC" "D = 10^6 kPa/mm" "D = 0.5 kPa/mm, compression"'
plot file('ugimp_usavg') using 1:($3*1e6) smooth unique with lines ls 1 title 'exact', \
     for [v in 'ugimp_usavg_stiff ugimp_compression'] file(v) using 1:($3*1e6) smooth unique with lines ls 1 notitle, \
     for [i=1:words(names)] file(word(names, i)) using 1:($2*1e6) with points ls 1+i title word(titles, i)
