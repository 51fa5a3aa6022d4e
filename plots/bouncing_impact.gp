# The source's figures 10 and 11: the disk at the start, and disk and plate at the deepest point of the impact.
load 'style.gnuplot'
set terminal pngcairo size 1500,1000 font ',20'
set output 'bouncing_impact.png'
set multiplot title 'Elastic disk (particles) on an elastic plate (finite elements, grey) in one grid, J = 2'
set xlabel 'x [m]'
set ylabel 'y [m]'
unset key
unset colorbox
set size ratio -1
set palette defined (-1 '#bbbbbb', -0.01 '#bbbbbb', 0 '#ffffff', 1 '#d9e6f2', 9 '#8fbbdc')
set cbrange [-1:9]
set origin 0,0
set size 0.4,0.95
set title 'start'
set xrange [0:1.28]
set yrange [-0.16:1.84]
d = 'data/bouncing-impact/'
plot d.'domains_0000.csv' using (column('x')):(column('y')):(column('flag')) with filledcurves closed fc palette, \
     d.'domains_0000.csv' using (column('x')):(column('y')) with lines lc rgb '#cccccc' lw 1 dt solid, \
     d.'particles_0000.csv' using (column('body') == 0 ? column('x') : 1/0):(column('y')) with dots lc rgb '#d55e00'
set origin 0.4,0
set size 0.6,0.95
set title 'impact, t = 0.561 s: von Mises stress'
set xrange [0.36:0.92]
set yrange [-0.17:0.35]
set colorbox
set cblabel 'von Mises stress [MPa]'
set palette defined (0 '#fff5eb', 0.5 '#fd8d3c', 1 '#7f2704')
set cbrange [0:*]
set cbtics 0.5
plot d.'particles_0001.csv' using (column('x')):(column('y')):(column('mises')/1e6) with points pt 7 ps 0.5 lc palette, \
     d.'domains_0001.csv' using (column('x')):(column('y')) with lines lc rgb '#888888' lw 1 dt solid
unset multiplot
