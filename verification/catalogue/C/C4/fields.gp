# Vertical stress and horizontal velocity in the disk that rolls and in the one that slips.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 860,680 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
empty = -1e29
pixel = 0.125
file(v, what) = data.'/data-'.v.'-'.what.'.dat'
set xrange [16:40]
set yrange [-2:17]
set size ratio -1
set tics scale 0.4
unset key
unset grid
set xlabel 'x (mm)'
set ylabel 'y (mm)'
set multiplot layout 2,2 margins 0.1, 0.9, 0.12, 0.95 spacing 0.2, 0.16
do for [k = 1:2] {
    v = word('rolls_4 slips_4', k)
    set title word('rolls slips', k).': σ_{yy} (MPa)'
    set palette defined (-1 '#0072B2', 0 '#ffffff', 1 '#D55E00')
    set cbrange [-0.006:0.006]
    plot file(v, 'stress') matrix using (($1 + 0.5)*pixel + 16):(($2 + 0.5)*pixel - 2):($3 < empty ? NaN : $3) with image
    set title word('rolls slips', k).': velocity down the incline (mm/ms)'
    set palette defined (0 '#ffffff', 1 '#0072B2', 2 '#202020')
    set cbrange [0:1.9]
    plot file(v, 'speed') matrix using (($1 + 0.5)*pixel + 16):(($2 + 0.5)*pixel - 2):($3 < empty ? NaN : $3) with image
}
unset multiplot
