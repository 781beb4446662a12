# The history: energies and the range of det F over time.
#
# Set before: output, format, title_text, time (unit), energy (unit), columns (names of the energies);
# history.csv: the file of the run.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set encoding utf8
if (format eq 'png') {
    set terminal pngcairo size 1200,1050 enhanced font 'Helvetica,20'
} else {
    set terminal svg size 800,700 dynamic enhanced font 'Helvetica,Arial,sans-serif,14'
}
set output output
set datafile separator ','
set datafile commentschars '#'
# colours of Okabe and Ito, each with a dash of its own
array colour[7] = ['#000000', '#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', '#56B4E9']
set border 3 lw 0.8
set tics nomirror out scale 0.6
set grid lc rgb '#cccccc' lw 0.5
set key outside right top noenhanced samplen 2
set lmargin 12
set rmargin 22
name_of(c) = word(columns, c)
label_of(text, unit) = text.(unit eq '' ? '' : ' / '.unit)
set multiplot layout 2,1 title title_text noenhanced
set ylabel label_of('energy', energy) noenhanced
plot for [c = 1:words(columns)] 'history.csv' using 'time':name_of(c) with lines lw 1.8 dt c \
     lc rgb colour[1 + (c - 1)%7] title name_of(c)
set xlabel label_of('time', time) noenhanced
set ylabel 'det F'
plot 'history.csv' using 'time':'j_max' with lines lw 1.8 lc rgb colour[3] title 'largest', \
     'history.csv' using 'time':'j_min' with lines lw 1.8 dt 2 lc rgb colour[2] title 'smallest'
unset multiplot
unset output
