# Particles where they are at the end, coloured by the error of the displacement.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set terminal svg size 760,640 dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
set size ratio -1
set xlabel 'x (m)'
set ylabel 'y (m)'
set xrange [-0.75:0.75]
set yrange [-0.75:0.75]
set cblabel 'error of the displacement (%)'
set palette defined (0 '#f0f0f0', 0.25 '#56B4E9', 0.6 '#0072B2', 1 '#D55E00')
set rmargin 12
plot data.'/data-field_cpdi_usl-field.dat' using ($1+$3):($2+$4):(100*$5/0.1) with points pt 7 ps 0.45 lc palette notitle
