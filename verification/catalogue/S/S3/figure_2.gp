# S3: S_r near the axis, after N&G Fig. 2.
# SPDX-License-Identifier: GPL-3.0-or-later
set xlabel "2r / Δr"
set ylabel "S_r"
set xrange [-3:6]
set yrange [-0.25:1.0]
set xtics 1
set ytics 0.25
set key outside top center horizontal
do for [node = -1:2] {
    set arrow from 2 * node, graph 0 to 2 * node, graph 1 nohead linecolor "#999999" dashtype 3
    set label sprintf("n_i = %d", node) at 2 * node, graph 0.04 offset character 0.4, 0
}
truncated = "data-ugimp-truncated.dat"
untruncated = "data-ugimp-untruncated.dat"
planar = "data-ugimp-planar.dat"
plot for [node = -1:2] planar using 1:(column(node + 3)) with lines linecolor "#0072B2" \
         dashtype 2 linewidth 1 title (node == 0 ? "planar" : ""), \
     for [node = -1:1] untruncated using 1:(column(node + 3)) with lines linecolor "#D55E00" \
         dashtype 3 linewidth 2 title (node == 0 ? "axisymmetric, untruncated" : ""), \
     for [node = -1:2] truncated using 1:(column(node + 3)) with lines linecolor "#000000" \
         linewidth 2 title (node == 0 ? "axisymmetric, truncated" : "")
