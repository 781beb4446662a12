# Largest stable Courant number: methods down, problems across.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
n = words(variants)
set terminal svg size 760,130+22*n dynamic enhanced font 'Helvetica,Arial,sans-serif,14' name name linewidth 1 rounded
set output output
unset grid
unset key
set lmargin 24
set tmargin 4
set border 0
set xrange [-0.5:5.5]
set yrange [n+0.5:0.5]
set x2range [-0.5:5.5]
set cbrange [0:2.5]
unset xtics
set xlabel 'bar, block and spin, of small and of large displacements'
set x2tics ("bar\nsmall" 0, "bar\nlarge" 1, "block\nsmall" 2, "block\nlarge" 3, "spin\nsmall" 4, "spin\nlarge" 5) scale 0
set ytics scale 0 noenhanced
do for [i=1:n] { set ytics add (word(variants, i) i) }
set palette defined (0 '#67001f', 0.4 '#d6604d', 0.8 '#fddbc7', 1.2 '#d1e5f0', 1.6 '#4393c3', 2.5 '#053061')
set cblabel 'largest stable Courant number'
set style fill solid 1 noborder
file(i) = data.'/data-'.word(variants, i).'-limits.dat'
plot for [i=1:n] file(i) using 1:(i):(0.48):(0.46):3 with boxxyerror lc palette, \
     for [i=1:n] file(i) using 1:(i):(sprintf('%.2f', $3)):($3 < 0.5 || $3 > 1.62 ? 0xffffff : 0x101010) \
         with labels font ',12' tc rgb variable
