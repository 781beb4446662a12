# CRAMP Fig. 3: the collision in four pictures. Values of the scale run from dark to light without a turn, so that it reads in
# grey as well.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 760,500 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
empty = -1e29
pixel = 0.2
file(name) = data.'/data-ugimp_usavg_frames-frame_'.name.'.dat'
times = '0 6.0 12.5 15.8'
set palette defined (0 '#30123b', 1 '#3e5fb0', 2 '#2f97a8', 3 '#57bf7a', 4 '#bfdc4a', 5 '#fdf3a0')
set cbrange [-20:10]
set cblabel 'σ_{yy} (kPa)'
set xrange [-37:37]
set yrange [-18:18]
set size ratio -1
unset key
unset grid
unset xlabel
set tics scale 0.4
set xtics -30,10,30
set ytics -10,10,10
set multiplot layout 2,2 margins 0.11, 0.87, 0.15, 0.92 spacing 0.05, 0.17
do for [k = 1:4] {
    set label 1 sprintf('%c: %s ms', 64 + k, word(times, k)) at graph 0.5, 1.09 center front
    if (k % 2 == 1) { set ylabel 'y (mm)' } else { unset ylabel }
    if (k > 2) { set xlabel 'x (mm)' }
    if (k > 1) { unset colorbox }
    if (k == 1) { set colorbox user origin 0.89, 0.12 size 0.022, 0.8 }
    plot file(sprintf('%d', k)) matrix using (($1 + 0.5)*pixel - 37):(($2 + 0.5)*pixel - 18):($3 < empty ? NaN : $3*1e3) with image, \
         file(sprintf('%d-cracks', k)) using 1:($3 == 0 ? $2 : NaN) with lines lc rgb '#000000' lw 1.5, \
         file(sprintf('%d-cracks', k)) using 1:($3 == 1 ? $2 : NaN) with lines lc rgb '#000000' lw 1.5
}
unset multiplot
