# S1: largest error by region of samples.
# SPDX-License-Identifier: GPL-3.0-or-later
set ylabel "largest |code − reference|"
set logscale y
set format y "10^{%L}"
set yrange [1e-17:1e-10]
set xrange [-0.5:4.5]
set xtics ("near" 0, "grid lines" 1, "axis" 2, "far, exact" 3, "far, anywhere" 4)
set key outside right
array variant[9] = ["classic_planar", "classic_truncated", "classic_untruncated", \
                    "ugimp_planar", "ugimp_truncated", "ugimp_untruncated", \
                    "cpdi_planar", "cpdi_truncated", "cpdi_untruncated"]
array label[9] = ["classic, planar", "classic, truncated", "classic, untruncated", \
                  "uGIMP, planar", "uGIMP, truncated", "uGIMP, untruncated", \
                  "CPDI, planar", "CPDI, truncated", "CPDI, untruncated"]
array colour[3] = ["#000000", "#0072B2", "#D55E00"]
array marker[9] = [1, 2, 3, 4, 6, 8, 5, 7, 9]
data(i) = sprintf("data-%s-errors.dat", variant[i])
larger(a, b) = a > b ? a : b
place(region, i) = region + 0.08 * (i - 5)
# An error of exactly zero (exact positions) is drawn on the lower edge.
error(a, b, c, d) = larger(1e-17, larger(larger(a, b), larger(c, d)))
plot 1e-12 with lines linecolor "#000000" dashtype 2 title "criterion", \
     2e-11 with lines linecolor "#999999" dashtype 2 title "criterion, far, anywhere", \
     for [i = 1:9] data(i) using (place($1, i)):(error($2, $3, $4, $5)) with points \
         linecolor rgb colour[1 + (i - 1) / 3] pointtype marker[i] title label[i], \
     for [i = 4:9] data(i) using (place($1, i)):6 with points linecolor "#999999" pointtype "–" \
         title (i == 4 ? "bound by GSL" : "")
