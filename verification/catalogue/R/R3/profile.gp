# J over the initial radius for each grid; the finest one is of the full size alone.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'initial radius r_0 (mm)'
set ylabel 'relative volume J (%)'
set xrange [30:50]
set yrange [8:24]
set key top left
h4 = data.'/data-h4-profile.dat'
has_h4 = sum [i = 1:words(variants)] (word(variants, i) eq 'h4')
plot 16 with lines ls 8 title 'exact', \
     data.'/data-h1-profile.dat' using 1:3 with points ls 1 title 'h = 2.5 mm', \
     data.'/data-h2-profile.dat' using 1:3 with points ls 2 title 'h = 1.25 mm', \
     has_h4 ? h4 : data.'/data-h2-profile.dat' using 1:(has_h4 ? $3 : NaN) with points ls 3 title (has_h4 ? 'h = 0.625 mm' : '')
