# K_I against a/W, and its difference from the handbook; the band is that of the check.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
feddersen(x) = sqrt(1/cos(pi*x/2))
tada(x) = feddersen(x)*(1 - 0.025*x**2 + 0.06*x**4)
file(v) = data.'/data-'.v.'-contours.dat'
fine(v) = strstrt(v, 'fine') > 0
style_of(v) = fine(v) ? 3 : 2
first(k) = k == 1 || fine(word(variants, k)) && !fine(word(variants, k - 1)) || !fine(word(variants, k)) && fine(word(variants, k - 1))
cells(v) = fine(v) ? 'uGIMP, cells of 0.5, every contour' : 'uGIMP, cells of 1, every contour'
legend(k) = first(k) ? cells(word(variants, k)) : ''
set xrange [0.2:0.85]
set samples 200
set multiplot layout 2,1
set lmargin 11
set bmargin 0.5
set format x ''
set ylabel 'K_I / σ√(πa)'
set key top left
plot '+' using 1:(0.98*tada($1)):(1.02*tada($1)) with filledcurves lc rgb '#d0d0d0' title '± 2 %', \
     tada(x) with lines ls 1 title 'Tada', \
     feddersen(x) with lines ls 8 dt (6,4) title 'Feddersen', \
     for [k = 1:words(variants)] file(word(variants, k)) using 2:($4*tada($2)) with points ls style_of(word(variants, k)) title legend(k)
set bmargin 4
set tmargin 0.5
set format x '%g'
set xlabel 'a/W'
set ylabel 'over the handbook, %'
set yrange [-2.6:2.6]
unset key
plot '+' using 1:(-2):(2) with filledcurves lc rgb '#d0d0d0', \
     0 with lines ls 1, \
     100*(feddersen(x)/tada(x) - 1) with lines ls 8 dt (6,4), \
     for [v in variants] file(v) using 2:(100*($4 - 1)) with points ls style_of(v)
unset multiplot
