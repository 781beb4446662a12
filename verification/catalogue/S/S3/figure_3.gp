# S3: dS_r near the axis, after N&G Fig. 3.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set xlabel '2r / Δr'
set ylabel 'gradient dS_r of the shape function (1)'
set xrange [-3:6]
set yrange [-1:1]
set xtics 1
set ytics 0.2
set key outside top center horizontal
do for [node = -1:2] {
    set arrow from 2 * node, graph 0 to 2 * node, graph 1 nohead lc rgb '#777777' dt (1, 3)
    set label sprintf('n = %d', node) at 2 * node, graph 0.04 offset character 0.4, 0
}
curve(name) = data.'/data-ugimp-'.name.'.dat'
plot for [node = -1:2] curve('planar') using 1:(column(node + 7)) with lines ls 2 lw 1 \
         title (node == 0 ? 'planar' : ''), \
     for [node = -1:1] curve('untruncated') using 1:(column(node + 7)) with lines ls 3 dt (2, 3) \
         title (node == 0 ? 'not truncated' : ''), \
     for [node = -1:2] curve('truncated') using 1:(column(node + 7)) with lines ls 1 \
         title (node == 0 ? 'truncated' : '')
