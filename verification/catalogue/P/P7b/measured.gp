# Comparison error of each bar, with the uncertainty of validation.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 860,460 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
bars = 'copper_130 copper_146 copper_162 copper_210 copper_316 steel_208'
file(k) = data.'/data-'.word(bars, k).'-validation.dat'
set xrange [0.4:6.6]
set yrange [-25:25]
set xtics ('Cu 130' 1, 'Cu 146' 2, 'Cu 162' 3, 'Cu 210' 4, 'Cu 316' 5, '4340 208 m/s' 6)
set ylabel 'simulated less measured (%)'
set xzeroaxis
set key bottom left
plot for [k = 1:6] file(k) every ::0::0 using (k - 0.1):3:6 with yerrorbars ls 2 pt 7 title (k == 1 ? 'final length' : ''), \
     for [k = 1:6] file(k) every ::1::1 using (k + 0.1):3:6 with yerrorbars ls 3 pt 5 title (k == 1 ? 'final diameter' : '')
