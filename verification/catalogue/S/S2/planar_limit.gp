# S2: approach of the axisymmetric to the planar functions.
# SPDX-License-Identifier: GPL-3.0-or-later
set xlabel "r_p / Δr"
set ylabel "difference from the planar function"
set logscale xy
set format x "10^{%L}"
set format y "10^{%L}"
set xrange [3e2:3e9]
set key top right
ugimp = "data-ugimp_truncated-limit.dat"
cpdi = "data-cpdi_truncated-limit.dat"
size = 0.5
plot size**2 / 12 / x with lines linecolor "#000000" title "l_p^2/12 over r_p/Δr", \
     size / 4 / x with lines linecolor "#000000" dashtype 2 title "l_p/4 over r_p/Δr", \
     ugimp using 1:3 with points linecolor "#009E73" pointtype 8 title "uGIMP, Δr G_r, over a node", \
     ugimp using 1:2 with points linecolor "#0072B2" pointtype 6 title "uGIMP, S_r, inside a cell", \
     cpdi using 1:2 with points linecolor "#D55E00" pointtype 2 title "CPDI, S_r, inside a cell"
