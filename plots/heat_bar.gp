# Review figure 51: a bar heated at its right end. Temperatures of nodes and particles at three times, particles near the heated end with
# line 10 of Algorithm 8 as printed and mended, and the errors against the cell size.
load 'style.gnuplot'
set terminal pngcairo size 1900,640 font ',19'
set output 'heat_bar.png'
set multiplot layout 1,3 title 'A bar heated at its right end (Algorithm 8)'
times = '0.0075 0.03 0.05'
frames = '0003 0012 0020'
file(what, k) = 'data/heat-bar/' . what . '_' . word(frames, k) . '.csv'
set title '100 cells, 1 particle per cell'
set xlabel 'position x / L'
set ylabel 'temperature (T - T_0)/(T_1 - T_0)'
set key top left Left reverse samplen 2 spacing 1.1
set xrange [0.2:1]
set yrange [0:1.05]
plot for [k=1:3] file('particles', k) using (column('x')):(column('T')) every 2 with points pt 6 ps 0.9 lw 1.4 lc rgb word('#0072b2 #d55e00 #009e73', k) notitle, \
     for [k=1:3] file('nodes', k) using (column('x')):(column('T')) with lines lw 2.2 dt k lc rgb word('#0072b2 #d55e00 #009e73', k) title 'nodes, t = '.word(times, k), \
     for [k=1:3] file('nodes', k) using (column('x')):(column('T_exact')) every 2 with points pt 7 ps 0.3 lc rgb 'black' title k == 1 ? 'exact' : '', \
     NaN with points pt 6 ps 0.9 lw 1.4 lc rgb 'black' title 'particles'
set title 'near the heated end, t = 0.05, 2 per cell'
set xrange [0.94:1.002]
set yrange [0.2:1.05]
set xtics 0.02
set key bottom left Left reverse samplen 2 spacing 1.2
plot 'data/heat-bar-mended/nodes_0020.csv' using (column('x')):(column('T_exact')) with lines lt 1 title 'exact', \
     'data/heat-bar-mended/nodes_0020.csv' using (column('x')):(column('T')) with points pt 2 ps 1.6 lw 2.5 lc rgb '#009e73' title 'nodes', \
     'data/heat-bar-mended/particles_0020.csv' using (column('x')):(column('T')) with points pt 6 ps 1.8 lw 2.5 lc rgb '#0072b2' title 'particles, mended', \
     'data/heat-bar-printed/particles_0020.csv' using (column('x')):(column('T')) with points pt 5 ps 1.4 lc rgb '#d55e00' title 'particles, as printed'
set title 'rms errors, t = 0.05, 2 per cell'
set xlabel 'cell size h / L'
set ylabel 'rms error / (T_1 - T_0)'
set key bottom right Left reverse samplen 3 spacing 1.1
set logscale xy
set xtics ('1/160' 1./160, '1/80' 1./80, '1/40' 1./40, '1/20' 1./20, '1/10' 1./10)
set xrange [1./220:1./8]
set yrange [1e-8:0.5]
set format y '10^{%T}'
e(name) = strcol('error_name') eq name ? column('error') : NaN
set datafile missing NaN
plot 'data/heat-bar-printed-cells/summary.csv' using (column('h')):(e('particles')) with linespoints lt 2 pt 5 ps 1.5 title 'particles, as printed', \
     'data/heat-bar-mended-cells/summary.csv' using (column('h')):(e('particles')) with linespoints lt 3 pt 6 ps 1.8 title 'particles, mended', \
     'data/heat-bar-printed-cells/summary.csv' using (column('h')):(e('nodes')) with linespoints lt 4 pt 9 ps 1.5 title 'nodes, as printed', \
     'data/heat-bar-mended-cells/summary.csv' using (column('h')):(e('nodes')) with linespoints lt 5 pt 7 ps 1.5 title 'nodes, mended', \
     0.25 * x**2 with lines lt 1 lw 1.5 dt (2,4) title 'order 2'
unset multiplot
