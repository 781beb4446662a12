# CRAMP Fig. 4: photoelastic fringes in five disks. The scale is grey, as a polariscope shows it.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 900,640 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
empty = -1e29
full = variants eq 'ugimp_usavg_58016'
pixel = full ? 0.5 : 1.0
times = full ? '10.0 18.0 26.8' : '10.0 18.0 25.4'
file(name) = data.'/data-'.variants.'-frame_'.name.'.dat'
set palette defined (-1 '#202020', 1 '#ffffff')
set cbrange [-1:1]
set cbtics 1
set cblabel 'cos(k (σ_1 − σ_2))'
set xrange [-14:304]
set yrange [-34:34]
set size ratio -1
set tics scale 0.4
set ytics 30
set ylabel 'y (mm)'
do for [k = 0:4] { set object (k + 1) circle at 30 + 60*k, 0 size 30 front fs empty border lc rgb '#808080' lw 0.6 }
set object 6 rectangle from -11, -17 to 0, 17 behind fs empty border lc rgb '#808080' lw 0.6
unset key
unset grid
set multiplot layout 3,1 margins 0.09, 0.88, 0.11, 0.98 spacing 0, 0.06
do for [k = 1:3] {
    set label 1 sprintf('%s µs', word(times, k)) at -12, 29 left front
    if (k > 1) { unset colorbox }
    if (k == 1) { set colorbox user origin 0.9, 0.15 size 0.02, 0.7 }
    if (k == 3) { set xlabel 'x (mm)' }
    plot file(sprintf('%d', k)) matrix using (($1 + 0.5)*pixel - 14):(($2 + 0.5)*pixel - 34):($3 < empty ? NaN : $3) with image, \
         file(sprintf('%d-cracks', k)) using 1:2 with lines lc rgb '#D55E00' lw 2
}
unset multiplot
