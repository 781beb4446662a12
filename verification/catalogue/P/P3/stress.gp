# Stress over the radius at the end of each stage.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 860,480 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
file(k) = data.'/data-ugimp_coarse-state_'.k.'.dat'
set xrange [10:20]
set yrange [-1.3:1]
set ytics 0.5
set xlabel 'distance from the centre (mm)'
set multiplot layout 1,3 margins 0.11, 0.98, 0.19, 0.9 spacing 0.05, 0
set ylabel 'stress / Y'
set key bottom right
do for [k = 1:3] {
    set title word('0.5 1.11 0', k).' Y inside'
    plot file(k) using 1:($2*10) with points ls 2 ps 0.3 title 'radial', \
         file(k) using 1:($3*10) with points ls 3 ps 0.3 title 'hoop', \
         file(k) using 1:($5*10) smooth unique with lines ls 1 title 'exact', \
         file(k) using 1:($6*10) smooth unique with lines ls 1 notitle
    set ylabel ''
    set format y ''
    unset key
}
unset multiplot
