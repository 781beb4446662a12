# J over the initial radius at a strain of -0.6.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'initial radius r_0 (mm)'
set ylabel 'relative volume J (%)'
set xrange [0:50]
set yrange [8:22]
set key top left
plot 16 with lines ls 8 title 'exact', \
     data.'/data-ugimp_musl-profile.dat' using 1:3 with points ls 1 title 'uGIMP', \
     data.'/data-cpdi_musl-profile.dat' using 1:3 with points ls 2 title 'CPDI'
