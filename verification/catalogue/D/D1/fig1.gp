# CRAMP Fig. 1: the specimen at rest, whole and half, by the stress along it.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 900,480 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
empty = -1e29
pixel = 0.2
file(model) = data.'/data-ugimp_musl_rest-'.model.'.dat'
set palette defined (0 '#30123b', 1 '#3e5fb0', 2 '#2f97a8', 3 '#57bf7a', 4 '#bfdc4a', 5 '#fdf3a0')
set cbrange [-1.2:1.2]
set cblabel 'σ_{xx} (kPa)'
set xrange [-2:102]
set yrange [-9:15]
set size ratio -1
set tics scale 0.4
set ytics 6
unset key
unset grid
set multiplot layout 2,1 margins 0.06, 0.86, 0.13, 0.98 spacing 0, 0.08
models = 'whole half'
do for [k = 1:2] {
    model = word(models, k)
    if (k == 1) { set colorbox user origin 0.88, 0.15 size 0.02, 0.75 } else { unset colorbox; set xlabel 'x (mm)' }
    set label 1 model at 100, -7 right front
    plot file(model) matrix using (($1 + 0.5)*pixel - 2):(($2 + 0.5)*pixel - 9):($3 < empty ? NaN : $3*1e3) with image
}
unset multiplot
