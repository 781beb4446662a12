# Energies of rod and target over time.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'time (μs)'
set ylabel '% of the kinetic energy at the start'
set xrange [0:60]
set yrange [0:100]
set key left center
energies = data.'/data-fig9-energies.dat'
plot energies using ($1*1e3):2 with lines ls 2 title 'kinetic', \
     energies using ($1*1e3):3 with lines ls 4 title 'elastic, pressure included', \
     energies using ($1*1e3):4 with lines ls 3 title 'heat', \
     energies using ($1*1e3):5 with lines ls 5 title 'plastic work that is no heat', \
     energies using ($1*1e3):7 with lines ls 6 title 'lost'
