# Angle of the stress to the rate of strain over time.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (unit of the scene)'
set ylabel 'angle ψ of the stress to the rate of strain (rad)'
set xrange [0:1]
set yrange [0:1.5]
set key top right
plot data.'/data-musl-path.dat' using 1:3 with lines ls 1 title 'exact', \
     data.'/data-musl-path.dat' using 1:2 every 10 with points ls 2 title 'MUSL', \
     data.'/data-usavg-path.dat' using 1:2 every 10::5 with points ls 3 title 'USAVG'
