# Pressure and velocity along the axis at first contact.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'z (mm)'
set xrange [-1.2:1.6]
set ylabel 'pressure (GPa)'
set yrange [0:70]
set y2label 'velocity (m/s)'
set y2range [0:2400]
set ytics nomirror
set y2tics
set key top right
profile = data.'/data-apic-profile.dat'
exact = data.'/data-apic-exact.dat'
plot exact using 1:3 with lines ls 1 title 'exact', \
     exact using 1:2 axes x1y2 with lines ls 1 notitle, \
     profile using 1:3 with points ls 2 ps 0.3 title 'pressure', \
     profile using 1:2 axes x1y2 with points ls 3 ps 0.3 title 'velocity'
