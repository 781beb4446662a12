# Photoelastic fringes at the instant of CRAMP's photograph, on one velocity field and in contact.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 900,480 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
empty = -1e29
file(v) = data.'/data-'.v.'-frame_1.dat'
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
set object 6 rectangle from -11, -17 to 0, 17 behind fs empty border lc rgb '#808080' lw 0.6
$disks << end
30 0 30
90 0 30
150 0 30
210 0 30
270 0 30
end
set style fill empty
unset key
unset grid
set format x ''
set multiplot layout 2,1 margins 0.08, 0.88, 0.17, 0.89 spacing 0, 0.11
set title 'one velocity field, 25.4 µs'
set colorbox user origin 0.9, 0.2 size 0.02, 0.68
plot file('field') matrix using (($1 + 0.5) - 14):(($2 + 0.5) - 34):($3 < empty ? NaN : $3) with image, \
     $disks using 1:2:3 with circles lc rgb '#808080' lw 0.6
set title 'contact, 27.7 µs'
unset colorbox
set format x '%g'
set xlabel 'x (mm)'
plot file('contact') matrix using (($1 + 0.5) - 14):(($2 + 0.5) - 34):($3 < empty ? NaN : $3) with image, \
     $disks using 1:2:3 with circles lc rgb '#808080' lw 0.6
unset multiplot
