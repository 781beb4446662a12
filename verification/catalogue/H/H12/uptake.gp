# Solvent that a slab takes up through one side.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time D t/a^2'
set ylabel 'solvent over that of saturation'
set xrange [0:1]
set yrange [0:1]
set key top left
plot data.'/data-slab_ugimp-uptake.dat' using 1:3 with lines ls 1 title 'exact', \
     data.'/data-slab_ugimp-uptake.dat' using 1:2 every 2 with points ls 2 title 'uGIMP, 32 cells'
