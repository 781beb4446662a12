# CRAMP Fig. 6: total energy under the four orders, one panel a family.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (ms)'
set xrange [0:6]
set yrange [0.8:1.2]
set lmargin 10
set rmargin 1
set multiplot layout 1,3
do for [family in 'classic ugimp cpdi'] {
    set title family
    if (family eq 'classic') { set ylabel 'total energy / start' } else { unset ylabel }
    if (family eq 'ugimp') { set key top left } else { unset key }
    plot data.'/data-'.family.'_usl-energy.dat' using 1:2 with lines ls 1 title 'USL', \
         data.'/data-'.family.'_musl-energy.dat' using 1:2 with lines ls 2 title 'MUSL', \
         data.'/data-'.family.'_usf-energy.dat' using 1:2 with lines ls 3 title 'USF', \
         data.'/data-'.family.'_usavg-energy.dat' using 1:2 with lines ls 4 title 'USAVG'
    unset label 9999 # the stamp, which one panel has drawn
}
unset multiplot
