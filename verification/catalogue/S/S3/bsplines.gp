# S3: B-splines at the edge of a grid, folded and not.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set xlabel 'x / Δx from the edge'
set xrange [0:3]
set yrange [-0.05:1.05]
set xtics 1
set ytics 0.25
unset key
curve(name) = data.'/data-'.name.'.dat'
set multiplot layout 1, 2
do for [family in 'bspline2 bspline3'] {
    if (family eq 'bspline2') { set ylabel 'weight' } else { unset ylabel }
    set title (family eq 'bspline2' ? 'quadratic' : 'cubic')
    plot for [node = -1:2] curve(family.'-free') using ($1 / 2):(column(node + 3)) with lines \
             ls 20 dt (5, 4) lw 1, \
         for [node = 0:3] curve(family.'-folded') using ($1 / 2):(column(node + 2)) with lines \
             ls (node + 1) dt 1
}
unset multiplot
