# The source's figure 12: height of the bouncing disk, with the correction of the receding contact and without, and by explicit contact.
load 'style.gnuplot'
set terminal pngcairo size 1500,1250 font ',20'
set output 'bouncing_height.png'
set multiplot layout 2,1 title 'Elastic disk on an elastic plate, 32 cells (J = 2), C_{E,1}'
set xlabel 'time t [s]'
set ylabel 'height of the centre - R [m]'
set xrange [0:1.28]
set yrange [-0.05:1.8]
set key top center horizontal samplen 3
h(name) = 'data/bouncing-'.name.'/history.csv'
plot h('free') using (column('t')):(column('height_rigid')) with lines lt 1 lw 1.5 title 'rigid, no loss', \
     h('free') using (column('t')):(column('height')) with lines lt 2 title 'coupled, C_c = 0', \
     h('table') using (column('t')):(column('height')) with lines lt 3 title 'coupled, C_c = 0.06 (Table 3)', \
     h('explicit') using (column('t')):(column('height')) with lines lt 4 title 'explicit, contact'
set ylabel 'energy / start [-]'
set yrange [0.9:1.15]
set key top left
names = 'free table explicit'
E0 = 1000 * pi * 0.16**2 * 9.81 * 1.52  # m g drop
plot 1 with lines lt 1 lw 1.5 notitle, \
     for [i=1:3] h(word(names, i)) using (column('t')):((column('total') + column('potential'))/E0) \
     with lines lt (i + 1) title word('C_c=0 C_c=0.06 explicit', i)
unset multiplot
