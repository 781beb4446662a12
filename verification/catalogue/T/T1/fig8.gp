# N&G Fig. 8: axial stress over the initial distance to the loaded edge.
# SPDX-License-Identifier: GPL-3.0-or-later
load style
set output output
set xlabel 'initial distance from the loaded edge (mm)'
set ylabel 'axial stress σ_{zz} over the exact stress (%)'
set xrange [0:40]
set yrange [0:200]
set key tmargin center horizontal maxcols 2 samplen 2.5 width -8 font ',12'
plot 100 with lines ls 1 title 'exact', \
     141.12 with lines ls 8 title 'exact under forces: 1411 of 1000 MPa', \
     data.'/data-cpdi-profile.dat' using (40-$2):($4/10) with points ls 2 title 'CPDI, traction', \
     data.'/data-cpdi_force-profile.dat' using (40-$2):($4/10) with points ls 3 title 'CPDI, particle forces', \
     data.'/data-ugimp_fifth-profile.dat' using (40-$2):($4/2) with points ls 4 title 'uGIMP, traction, at 200 MPa', \
     data.'/data-ugimp_force_fifth-profile.dat' using (40-$2):($4/2) with points ls 5 title 'uGIMP, particle forces, at 200 MPa'
