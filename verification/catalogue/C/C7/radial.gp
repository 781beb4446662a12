# Displacement and stress of all particles over the radius, against the exact ones.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 860,520 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
file(k) = data.'/data-'.word(variants, k).'-radial.dat'
name(k) = word('soft middle stiff', k)
set xrange [0:16]
set xlabel 'r (mm)'
set multiplot layout 1,2 margins 0.1, 0.98, 0.2, 0.91 spacing 0.12, 0
set title 'radial displacement'
set ylabel 'u (10^{-5} mm)'
set yrange [0:1.9]
set key top left
plot for [k = 1:3] file(k) every 3 using 1:($2*1e5) with points ls (1 + k) ps 0.5 title name(k), \
     for [k = 1:3] file(k) using 1:($5*1e5) smooth unique with lines ls 1 lw 1.5 notitle
set title 'radial (full), hoop stress (open), soft and stiff'
set ylabel 'σ (10^{-6} MPa)'
set yrange [-0.5:5]
set key bottom right
plot for [k = 1:3:2] file(k) every 3 using 1:($3*1e6) with points ls (1 + k) pt 7 ps 0.4 title name(k), \
     for [k = 1:3:2] file(k) every 3 using 1:($4*1e6) with points ls (1 + k) pt 6 ps 0.5 notitle, \
     for [k = 1:3:2] file(k) using 1:($6*1e6) smooth unique with lines ls 1 lw 1.5 notitle, \
     for [k = 1:3:2] file(k) using 1:($7*1e6) smooth unique with lines ls 1 lw 1.5 notitle
unset multiplot
