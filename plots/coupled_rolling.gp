# The source's figure 9: a disk rolls down an elastic plate of finite elements.
load 'style.gnuplot'
set terminal pngcairo size 1500,1350 font ',20'
set output 'coupled_rolling.png'
set multiplot title 'Elastic disk (E = 4.2e7 Pa) on an elastic plate of finite elements (8.4e7 Pa), incline of 45°'
set origin 0,0.54
set size 1,0.43
set title 'flags M_E, plate (grey) and particles at t = 1.25 s, J = 1'
set xlabel 'x along the plate [m]'
set ylabel 'y [m]'
set size ratio -1
set xrange [-0.3:20.3]
set yrange [-1.7:5.1]
set palette defined (-1 '#999999', -0.01 '#999999', 0 '#ffffff', 1 '#d9e6f2', 3 '#a6c8e0', 6 '#5a9bc9', 9 '#2a6496')
set cbrange [-1:9]
set cblabel 'M_E [-]'
unset key
plot 'data/coupled-rolling-40/domains_0001.csv' using (column('x')):(column('y')):(column('flag')) with filledcurves closed fc palette, \
     'data/coupled-rolling-40/domains_0001.csv' using (column('x')):(column('y')) with lines lc rgb '#bbbbbb' lw 1 dt solid, \
     'data/coupled-rolling-40/particles_0001.csv' using (column('body') == 0 ? column('x') : 1/0):(column('y')) with dots lc rgb '#d55e00'
set size noratio
set origin 0,0
set size 0.5,0.54
set title 'path of the centre'
set xlabel 'time t [s]'
set ylabel 'path [m]'
set xrange [0:2.5]
set yrange [0:17]
set key top left Left reverse samplen 3
plot 'data/coupled-rolling-40/history.csv' using (column('t')):(column('path')) with lines lt 2 title 'J = 1', \
     'data/coupled-rolling-80/history.csv' using (column('t')):(column('path')) with lines lt 3 title 'J = 2', \
     'data/coupled-rolling-40/history.csv' using (column('t')):(column('path_exact')) with lines lt 1 title 'rigid, rolls'
set origin 0.5,0
set title 'relative to the rigid disk'
set ylabel 'path / exact - 1 [-]'
set yrange [-0.2:0.2]
set key bottom right
plot 'data/coupled-rolling-40/history.csv' using (column('t')):(column('path') / column('path_exact') - 1) with lines lt 2 title 'J = 1', \
     'data/coupled-rolling-80/history.csv' using (column('t')):(column('path') / column('path_exact') - 1) with lines lt 3 title 'J = 2', \
     0 with lines lt 1 lw 1 notitle
unset multiplot
