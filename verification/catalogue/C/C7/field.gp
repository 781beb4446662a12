# Stress along x in a quarter of the block with a soft interface.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 860,470 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
empty = -1e29
file(v) = data.'/data-'.v.'-stress.dat'
set size ratio -1
set tics scale 0.4
unset key
unset grid
set palette defined (0 '#ffffff', 1.2 '#9ecae1', 2.4 '#0072B2', 3.5 '#08306b')
set cbrange [0:3.5]
set cblabel 'σ (10^{-6} MPa)'
set xrange [0:16]
set yrange [0:16]
set multiplot layout 1,2 margins 0.09, 0.88, 0.19, 0.93 spacing 0.08, 0
set object 1 circle at 0, 0 size 8 front fs empty border lc rgb '#D55E00' lw 1
unset colorbox
set title 'cylinder: σ_{xx}'
set xlabel 'x (mm)'
set ylabel 'y (mm)'
plot file('cylinder_soft') matrix using (($1 + 0.5)*0.1):(($2 + 0.5)*0.1):($3 < empty ? NaN : 1e6*$3) with image
set colorbox user origin 0.9, 0.2 size 0.02, 0.65
set title 'sphere: σ_{rr}'
set xlabel 'r (mm)'
set ylabel 'z (mm)'
plot file('sphere_soft') matrix using (($1 + 0.5)*0.1):(($2 + 0.5)*0.1):($3 < empty ? NaN : 1e6*$3) with image
unset multiplot
