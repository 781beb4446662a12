# Length grown over time.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (unit of the scene)'
set ylabel 'length grown (cells)'
set xrange [380:640]
set yrange [0:14]
set key bottom right
file(v) = data.'/data-'.v.'-growth.dat'
plot file('growth') using 1:3 with lines ls 1 title 'where J is the toughness', \
     file('growth') using 1:2 with points ls 2 title 'the tip'
