# N&G Fig. 7: mean stress against relative volume.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'relative volume J (%)'
set ylabel 'mean stress (GPa)'
set xrange [100:10]
set yrange [-20:8]
set key bottom left
plot data.'/data-cpdi_musl-curve.dat' using 2:($5/1000) with lines ls 1 dt 2 title 'exact σ_{rr} (66)', \
     '' using 2:($6/1000) with lines ls 2 dt 2 title 'exact σ_{zz} (67)', \
     data.'/data-ugimp_musl-curve.dat' using 2:($3/1000) every 12 with points ls 3 title 'uGIMP σ_{rr}', \
     '' using 2:($4/1000) every 12 with points ls 4 title 'uGIMP σ_{zz}', \
     data.'/data-cpdi_musl-curve.dat' using 2:($3/1000) every 12::6 with points ls 7 title 'CPDI σ_{rr}', \
     '' using 2:($4/1000) every 12::6 with points ls 6 title 'CPDI σ_{zz}'
