# NAFEMS T3: temperature along the bar after 32 s.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'place along the bar (m)'
set ylabel 'temperature (°C)'
set xrange [0:0.1]
set yrange [0:100]
set key top left
$nafems << end
0.08 36.60
end
plot data.'/data-ugimp-profile.dat' using 1:4 smooth unique with lines ls 1 title 'exact', \
     data.'/data-ugimp-profile.dat' using 1:3 every 5 with points ls 2 title 'uGIMP, FLIP, 40 cells', \
     data.'/data-pic-profile.dat' using 1:3 every 5 with points ls 3 title 'the same with PIC', \
     $nafems using 1:2 with points ls 8 pt 6 ps 2 title 'NAFEMS: 36.60 °C'
