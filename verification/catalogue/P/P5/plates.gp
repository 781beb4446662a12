# Pressure, density, energy and temperature along plates that have hit their mirror images.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 860,640 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set multiplot layout 2,2
set xlabel 'x (mm)'
set xrange [0:16]
file(v) = data.'/data-'.v.'-profile.dat'
labels = "'pressure (GPa)' 'density (g/cm³)' 'internal energy (kJ/kg)' 'temperature (K)'"
columns = "4 2 5 6"
do for [k=1:4] {
    c = int(word(columns, k))
    scale = k < 4 ? 1e3 : 1.0
    set ylabel word(labels, k)
    if (k == 1) { set key tmargin center horizontal maxcols 2 samplen 2; set yrange [0:*] } else { unset key; set autoscale y }
    plot file('tungsten_2000') using 1:(scale*column(c + 5)) with lines ls 1 title 'exact', \
         file('copper_1000') using 1:(scale*column(c + 5)) with lines ls 1 notitle, \
         file('tungsten_2000') using 1:(scale*column(c)) with points ls 2 ps 0.3 title 'tungsten, 2000 m/s', \
         file('copper_1000') using 1:(scale*column(c)) with points ls 3 ps 0.3 title 'copper, 1000 m/s'
}
unset multiplot
