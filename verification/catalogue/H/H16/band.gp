# Temperature across a band that is sheared between cooled faces.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'across the band (length)'
set ylabel 'rise (temperature)' offset 1.5, 0
set xrange [0:8]
set yrange [0:*]
set lmargin 11 # numbers of many digits
set key tmargin center horizontal maxcols 3 samplen 2.5
file = data.'/data-band_ugimp-profile.dat'
plot file using 1:($3 - 3) smooth unique with lines ls 1 title 'exact', \
     file using 1:($2 - 3) every 8 with points ls 2 title 'uGIMP'
