# Error over the step; exact: Euler steps of 0.04 to 0.005 s of the modes, see the README.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set logscale xy
set xlabel 'step (s)'
set xtics (0.005, 0.01, 0.02, 0.04)
set ylabel 'error of temperature (% of the amplitude)'
set xrange [0.004:0.05]
set yrange [0.2:6]
set ytics (0.2, 0.5, 1, 2, 5)
set key tmargin center horizontal maxcols 3 samplen 2.5 width -6
$exact << EOD
0.04 2.97261 3.80415
0.02 1.47224 1.88683
0.01 0.732629 0.939618
0.005 0.365446 0.468863
EOD
file(v) = data.'/data-'.v.'-levels_l2.dat'
plot $exact using 1:2 with lines ls 1 title 'exact, square', \
     $exact using 1:3 with lines ls 8 title 'exact, cylinder', \
     file('ramp_ugimp') using (0.04*$1):2 with points ls 2 title 'square, uGIMP', \
     file('ramp_vortex_cpdi') using (0.04*$1):2 with points ls 3 title 'square in the vortex, CPDI', \
     file('ramp_cylinder_bspline2') using (0.04*$1):2 with points ls 4 title 'cylinder, quadratic splines', \
     file('ramp_ring_ugimp') using (0.04*$1):2 with points ls 5 title 'cylinder in the vortex, uGIMP'
