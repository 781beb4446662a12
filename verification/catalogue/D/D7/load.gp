# Load of the double cantilever beam against the way of its ends.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'opening of the ends (mm)'
set ylabel 'load (mN/mm)'
set xrange [0:1.15]
set yrange [0:0.2]
set key top right
file(v) = data.'/data-'.v.'-crack.dat'
plot file('ugimp_beam') using 1:4 with lines ls 1 title 'fracture mechanics', \
     file('ugimp_beam') using 1:2 with points ls 2 title 'uGIMP', \
     file('ugimp_beam_coarse') using 1:2 with points ls 3 title 'the traction falls within a cell'
