# Pressure along and across the bar.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 860,480 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
file(v) = data.'/data-'.v.'-profile.dat'
set xrange [0:120]
set yrange [0:30]
set xlabel 'x at the start (mm)'
set multiplot layout 1,2 margins 0.09, 0.98, 0.19, 0.9 spacing 0.06, 0
set ylabel 'pressure (10^{-6} MPa)'
do for [v in 'ugimp_usavg ugimp_usavg_hardening'] {
    set title v eq 'ugimp_usavg' ? 'perfect plasticity' : 'hardening, H = G'
    plot file(v) using 1:($2*1e6) with points ls 2 ps 0.3 title 'along', \
         file(v) using 1:($3*1e6) with points ls 3 ps 0.3 title 'across', \
         file(v) using 1:($4*1e6) with lines ls 1 title 'exact', \
         file(v) using 1:($5*1e6) with lines ls 1 notitle
    set ylabel ''
    set format y ''
    unset key
}
unset multiplot
