# Pressure over volume in a Carnot cycle.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'volume V/V_0'
set ylabel 'pressure p/p_0'
set xrange [0.9:2.6]
set yrange [0.2:1.05]
set key top right
a = exp(0.3)
b = exp(0.6081976621622466)
g = 5.0/3
in(x, low, high) = x >= low && x <= high ? 1 : NaN
file = data.'/data-carnot_usavg-process.dat'
set samples 2000
plot in(x, 1, a)/x with lines ls 1 title 'exact', \
     in(x, a, a*b)*(x/a)**(-g)/a with lines ls 1 notitle, \
     in(x, b, a*b)*(2.0/3)/x with lines ls 1 notitle, \
     in(x, 1, b)*x**(-g) with lines ls 1 notitle, \
     file using 2:($4/6) every 4 with points ls 2 title 'gas'
