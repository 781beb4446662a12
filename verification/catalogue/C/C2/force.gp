# Force of contact over time, in units of the exact one.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time since the gap is closed (ms)'
set ylabel 'force / (p area)'
set xrange [-110:90]
set yrange [-0.1:2]
file(v) = data.'/data-'.v.'-force.dat'
exact(t) = t >= 0 && t < 64 ? 1 : 0
plot exact(x) with lines ls 1 title 'exact', \
     file('ugimp_usavg') using ($1-50):2 with lines ls 2 title '32 cells', \
     file('ugimp_levels') using ($1-100):2 with lines ls 3 title '128 cells', \
     file('ugimp_other') using ($1-50):2 with lines ls 4 title 'other target', \
     file('ugimp_shared') using ($1-250):2 with lines ls 5 title 'shared nodes'
