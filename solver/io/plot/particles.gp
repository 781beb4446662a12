# Particles with their domains, coloured by a field.
#
# Set before: output, format, title_text, unit (of the field), length (unit), axes ('x y' or 'r z');
# particles.dat: for each particle two rows of two corners and the value, and one of undefined points;
# outlines.dat: for each particle its corners, the first one again, and an undefined point.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set encoding utf8
if (format eq 'png') {
    set terminal pngcairo size 1200,900 enhanced font 'Helvetica,20'
} else {
    set terminal svg size 800,600 dynamic enhanced font 'Helvetica,Arial,sans-serif,14'
}
set output output
set title title_text noenhanced
set xlabel word(axes, 1).(length eq '' ? '' : ' / '.length) noenhanced
set ylabel word(axes, 2).(length eq '' ? '' : ' / '.length) noenhanced rotate
set cblabel label_text.(unit eq '' ? '' : ' / '.unit) noenhanced
set border 15 lw 0.7
set tics out nomirror scale 0.6
set format cb '%.4g'
# light to dark, also in grey and for the colour-blind
set palette defined (0 '#fde725', 1 '#7ad151', 2 '#22a884', 3 '#2a788e', 4 '#414487', 5 '#440154')
set cbrange [low:high]
set xrange [left:right]
set yrange [bottom:top]
set size ratio (top - bottom)/(right - left)
set view map
set pm3d corners2color c1 noborder
unset key
# half transparent, since thin domains are hidden by their outlines
splot 'particles.dat' using 1:2:3 with pm3d, \
      'outlines.dat' using 1:2:3 with lines lw 0.3 lc rgb '#80ffffff'
unset output
