# Views of the penetration, coloured by equivalent stress: N&G Fig. 9. Left which material is where.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 860,620 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set multiplot
unset key
set xrange [-12:12]
set yrange [-10:50]
set xtics 6
set xlabel 'r (mm)'
set cbrange [0:2]
set palette defined (0 '#dce6f2', 1 '#7fb0d8', 2 '#e0a040', 3 '#a02010')
set size ratio -1
times = "10 30 60"
do for [k=1:3] {
    set origin 0.32*(k - 1), 0.0
    set size 0.36, 1.0
    set title word(times, k).' μs, equivalent stress (GPa)' font ',12'
    dots = data.'/data-fig9-particles_'.k.'.dat'
    plot dots using 1:2:3 with points pt 7 ps 0.15 palette, \
         dots using (-$1):($4 == 1 ? $2 : 1/0) with points pt 7 ps 0.15 lc rgb '#d0d0d0', \
         dots using (-$1):($4 == 0 ? $2 : 1/0) with points pt 7 ps 0.15 lc rgb '#303030'
}
unset multiplot
