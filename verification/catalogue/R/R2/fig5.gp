# N&G Fig. 5: relative volume near the axis.
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
     data.'/data-cpdi_truncated-profile.dat' using 1:3 with points ls 2 title 'CPDI, truncated', \
     data.'/data-ugimp_untruncated-profile.dat' using 1:3 with points ls 3 title 'uGIMP, not truncated', \
     data.'/data-cpdi_untruncated-profile.dat' using 1:3 with points ls 4 title 'CPDI, not truncated'
