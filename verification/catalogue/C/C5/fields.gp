# Axial stress in a sphere between plates and in one that hits a plane.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 860,520 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
empty = -1e29
file(v) = data.'/data-'.v.'-stress.dat'
set size ratio -1
set tics scale 0.4
set xlabel 'r (mm)'
unset key
unset grid
set palette defined (-1 '#08306b', -0.5 '#0072B2', -0.15 '#9ecae1', 0 '#ffffff', 0.2 '#D55E00')
set cbrange [-0.15:0.03]
set multiplot layout 1,2 margins 0.09, 0.9, 0.15, 0.9 spacing 0.08, 0
set title 'between plates: σ_{zz} (MPa)'
set xrange [0:18]
set yrange [0:17]
set ylabel 'z (mm)'
unset colorbox
plot file('press_16_4') matrix using (($1 + 0.5)*0.1):(($2 + 0.5)*0.1):($3 < empty ? NaN : $3) with image
set title 'impact: σ_{zz} (MPa)'
set yrange [-1:33]
unset ylabel
set colorbox
plot file('impact_16_4') matrix using (($1 + 0.5)*0.2):(($2 + 0.5)*0.2 - 1):($3 < empty ? NaN : $3) with image
unset multiplot
