# J against the size of the contour.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'cells from the tip to the sides of the contour'
set ylabel 'J / handbook'
set key tmargin center horizontal maxcols 3 samplen 2.5 width -5
set yrange [0.9:1.5]
set xrange [1.5:8.5]
plot 1 with lines ls 1 title 'handbook', \
     data.'/data-beam_ugimp-contours.dat' using 1:3 with linespoints ls 2 title 'beam', \
     data.'/data-plate_ugimp-contours.dat' using 1:3 with linespoints ls 3 title 'plate', \
     data.'/data-penny_ugimp-contours.dat' using 1:3 with linespoints ls 4 title 'penny, Bergkvist and Huong', \
     data.'/data-penny_ugimp-contours.dat' using 1:5 with linespoints ls 5 title 'penny, Broberg', \
     data.'/data-penny_ugimp-contours.dat' using 1:7 with linespoints ls 6 title 'penny, no area term'
