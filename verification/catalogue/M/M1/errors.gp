# Errors of displacement, F and stress over the cell, one line for each family; bands about the
# slopes that theory gives. The fourth panel is the legend.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 760,680 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set logscale xy
set xrange [0.012:0.16]
set yrange [1e-4:0.6]
set format y '10^{%T}'
set xtics ('1/64' 1.0/64, '1/32' 1.0/32, '1/16' 1.0/16, '1/8' 1.0/8)
set xlabel 'cell over side'
set ylabel 'L2 error / L2 of the exact field'
set lmargin 9
file(v) = data.'/data-'.v.'_usavg-levels.dat'
# a power through (1/8, at) with the order p
power(h, at, p) = at * (8*h)**p
families = 'classic ugimp cpdi bspline2 bspline3'
titles = 'classic uGIMP CPDI "quadratic splines" "cubic splines"'
set style fill solid 0.25 noborder
set samples 60
unset key
set multiplot layout 2,2
do for [k=1:3] {
    set title word('displacement "deformation gradient F" "Cauchy stress"', k)
    set label 1 'slope 2 ± 0.15' at 0.0135, (k == 1 ? 2e-4 : 7e-4) font ',12' textcolor rgb '#808080'
    if (k > 1) { set label 2 'slope 1 ± 0.1' at 0.0135, 0.08 font ',12' textcolor rgb '#808080' }
    two = (k == 1 ? 0.045 : 0.14)
    plot '+' using 1:(power($1,two,2.15)):(power($1,two,1.85)) with filledcurves lc rgb '#bbbbbb' notitle, \
         '+' using 1:(k == 1 ? NaN : power($1,0.21,1.1)):(k == 1 ? NaN : power($1,0.21,0.9)) with filledcurves lc rgb '#bbbbbb' notitle, \
         for [i=1:5] file(word(families,i)) using 1:(column(k == 1 ? 3 : k == 2 ? 9 : 12)) with linespoints ls i+1 notitle
    unset label 1
    unset label 2
}
unset title
unset border
unset tics
unset grid
unset xlabel
unset ylabel
set key at graph 0.5, 0.75 center top samplen 4
plot for [i=1:5] NaN with linespoints ls i+1 title word(titles,i)
unset multiplot
