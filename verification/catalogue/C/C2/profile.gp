# Stress along both bars at half the contact time.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'distance from the contact (mm)'
set ylabel 'stress / p'
set xrange [-32:64]
set yrange [-1.6:0.9]
set samples 2000
file(v) = data.'/data-'.v.'-profile.dat'
exact(x) = abs(x) < 32 ? -1 : 0
plot exact(x) with lines ls 1 title 'exact', \
     file('ugimp_usavg') using 1:2 with points ls 2 title 'FLIP, 32 cells', \
     file('ugimp_usavg_fmpm2') using 1:2 with points ls 3 title 'FMPM, 32 cells', \
     file('ugimp_levels') using 1:2 with points ls 4 title 'FLIP, 128 cells'
