# Change of the total energy, one panel a family.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'distance carried (cells)'
set xrange [0:100]
set lmargin 9
set rmargin 3
set multiplot layout 1,2
set yrange [-50:50]
do for [family in 'ugimp classic'] {
    set title family
    if (family eq 'ugimp') { set ylabel 'change of energy / strain energy (%)' } else { unset ylabel; set yrange [-100:500]; unset key }
    if (family eq 'ugimp') { set key bottom left }
    plot data.'/data-'.family.'_usl-carried.dat' using 1:4 with lines ls 3 title 'USL', \
         data.'/data-'.family.'_musl-carried.dat' using 1:4 with lines ls 2 title 'MUSL', \
         data.'/data-'.family.'_usf-carried.dat' using 1:4 with lines ls 6 title 'USF', \
         data.'/data-'.family.'_usavg-carried.dat' using 1:4 with lines ls 4 title 'USAVG'
}
unset multiplot
