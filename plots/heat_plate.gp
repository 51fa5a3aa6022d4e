# Review figure 52: a plate heated from all sides, nodal temperatures beside the exact ones, and the errors against the cell size.
load 'style.gnuplot'
set terminal pngcairo size 1900,600 font ',19'
set output 'heat_plate.png'
set multiplot layout 1,3 title 'A plate heated from all sides (Algorithm 8, line 10 mended), t = 0.05'
set title '20 x 20 cells, 4 particles per cell: nodes'
set xlabel 'x / L'
set ylabel 'y / L' offset 1
set xrange [0:1]
set yrange [0:1]
set size ratio -1
set cbrange [40:100]
set cblabel 'temperature T [K]'
set palette defined (0 '#2c3e8f', 0.35 '#4fa3c7', 0.65 '#f3d77b', 1 '#b5202a')
set xtics 0.25
set ytics 0.25
unset key
plot 'data/heat-plate/nodes_0001.csv' using (column('x')):(column('y')):(column('T')) with image pixels notitle
set title 'difference to the exact temperature'
set cblabel 'T - T_{exact} [K]' offset 1
set cbrange [-0.5:0.5]
set palette defined (-1 '#2c3e8f', 0 '#ffffff', 1 '#b5202a')
plot 'data/heat-plate/nodes_0001.csv' using (column('x')):(column('y')):(column('T') - column('T_exact')) with image pixels notitle
set title 'rms errors'
set size noratio
set xlabel 'cell size h / L'
set ylabel 'rms error / (T_1 - T_0)'
set key bottom right Left reverse samplen 3 spacing 1.1
set logscale xy
set xtics ('1/40' 1./40, '1/20' 1./20, '1/10' 1./10)
set ytics auto
set xrange [1./55:1./8]
set yrange [1e-7:1]
set format y '10^{%T}'
e(name) = strcol('error_name') eq name ? column('error') : NaN
set datafile missing NaN
plot 'data/heat-plate-cells-printed/summary.csv' using (column('h')):(e('particles')) with linespoints lt 2 pt 5 ps 1.5 title 'particles, as printed', \
     'data/heat-plate-cells/summary.csv' using (column('h')):(e('particles')) with linespoints lt 3 pt 6 ps 1.8 title 'particles, mended', \
     'data/heat-plate-cells-printed/summary.csv' using (column('h')):(e('nodes')) with linespoints lt 4 pt 9 ps 1.5 title 'nodes, as printed', \
     'data/heat-plate-cells/summary.csv' using (column('h')):(e('nodes')) with linespoints lt 5 pt 7 ps 1.5 title 'nodes, mended', \
     x**2 with lines lt 1 lw 1.5 dt (2,4) title 'order 2'
unset multiplot
