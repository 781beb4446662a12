# N&G Fig. 6: relative volume near the axis with planar functions.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'initial radius r_0 (mm)'
set ylabel 'relative volume J (%)'
set xrange [0:20]
set yrange [0:30]
set key top right
plot 16 with lines ls 8 title 'exact', \
     data.'/data-ugimp_truncated-profile.dat' using 1:3 with points ls 1 title 'uGIMP, truncated', \
     data.'/data-ugimp_planar_free-profile.dat' using 1:3 with points ls 2 title 'planar, extra nodes free', \
     data.'/data-ugimp_planar_zero-profile.dat' using 1:3 with points ls 3 title 'planar, v_r = 0 there', \
     data.'/data-ugimp_planar_mirrored-profile.dat' using 1:3 with points ls 4 title 'planar, mirrored there'
