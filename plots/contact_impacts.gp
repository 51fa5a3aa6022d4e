# Impacts by contact on the grid against exact or estimated ones: bars head on (exact waves), two disks (their touch is exact), a disk on a rigid wall; and a
# bonded block of two bodies beside the whole block.
load 'style.gnuplot'
set terminal pngcairo size 1500,1120 font ',17'
set output 'contact_impacts.png'
set datafile missing NaN
array name[4] = ['one shared field', 'as printed', 'frictionless', 'friction 0.3']
set multiplot layout 2,2
set key left bottom Left reverse spacing 1.1
set xlabel 'time t [time]'
set title 'Two bars head on, exact: 0.05 to 0.25'
set ylabel 'mean velocity of the left bar / v_0 [-]'
set yrange [-1.2:1.2]
plot for [n in '25 50 200'] 'data/contact-bars/cells-'.n.'/history.csv' using (column('t')):(column('v_left')/0.01) with lines title n.' cells', \
     'data/contact-bars/cells-200/history.csv' using (column('t')):(column('v_left_exact')/0.01) with lines dt (3,3) lw 2 lc rgb '#606060' title 'exact'
set title 'Two disks, h = 1/20: they touch at 1.586'
set ylabel 'speed of the lower disk / first [-]'
v = 0.1*sqrt(2)
set arrow 1 from 1.5858,-1.2 to 1.5858,1.2 nohead lc rgb '#606060' dt (3,3)
plot for [i = 1:4] 'data/contact-disks-'.word('shared printed frictionless coulomb', i).'/history.csv' using (column('t')):(column('speed')/v) with lines \
     title name[i]
unset arrow 1
set title 'Disk on a rigid wall'
set ylabel 'velocity of the disk / v_0 [-]'
set key right bottom
plot for [n in '10 20'] 'data/contact-wall/cells-'.n.'/history.csv' using (column('t')):(column('speed')) with lines title sprintf('h = 1/%s', n), \
     'data/contact-wall/cells-20/history.csv' using (column('t')):(column('speed_rigid')) with lines dt (3,3) lw 2 lc rgb '#606060' title 'rebound at once'
set title 'Bonded block of two bodies and the whole block'
set ylabel 'sideways displacement [length]'
set yrange [*:*]
set key left bottom
plot 'data/contact-patch-whole/history.csv' using (column('t')):(column('x_upper')) with lines lw 6 lc rgb '#b0c8e0' title 'whole, upper part', \
     'data/contact-patch/history.csv' using (column('t')):(column('x_upper')) with lines dt (6,4) lw 2 lc rgb '#000000' title 'bonded, upper part', \
     'data/contact-patch-whole/history.csv' using (column('t')):(column('x_lower')) with lines lw 6 lc rgb '#f0c8a0' title 'whole, lower part', \
     'data/contact-patch/history.csv' using (column('t')):(column('x_lower')) with lines dt (2,3) lw 2 lc rgb '#a03000' title 'bonded, lower part'
unset multiplot
