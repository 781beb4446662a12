# Velocity over time.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (unit of the scene)'
set ylabel 'velocity over start'
set xrange [0:4]
set yrange [0:1.05]
file(v) = data.'/data-'.v.'-decay.dat'
plot file('grid') using 1:3 with lines ls 1 title 'exp(-t/2)', \
     file('ramp') using 1:3 with lines ls 7 title 'exp(-0.2 t - 0.075 t^2)', \
     file('thermostat') using 1:3 with lines ls 8 title '1/cosh(t/2)', \
     file('grid') every 8 using 1:2 with points ls 2 title 'constant rate', \
     file('ramp') every 8 using 1:2 with points ls 3 title 'rate that grows', \
     file('thermostat') every 8 using 1:2 with points ls 4 title 'thermostat'
