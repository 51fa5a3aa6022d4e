# The source's figures 5 and 6: flags M_E of the elements under the disk at J = 1, and the path of the centre.
load 'style.gnuplot'
set terminal pngcairo size 1500,1250 font ',20'
set output 'implicit_rolling.png'
set multiplot title 'Elastic disk on an incline of 45°, E = 4.2e8 Pa, Q9 elements, steps of 0.01 s'
set origin 0,0.56
set size 1,0.4
set title 'flags M_E (0: no particles) and particles at t = 1.25 s, J = 1'
set xlabel 'x along the plane [m]'
set ylabel 'y [m]'
set size ratio -1
set xrange [0:20]
set yrange [0:5]
set palette defined (0 '#ffffff', 1 '#d9e6f2', 3 '#a6c8e0', 6 '#5a9bc9', 9 '#2a6496')
set cbrange [0:9]
set cblabel 'M_E [-]'
unset key
plot 'data/implicit-rolling-40/domains_0001.csv' using (column('x')):(column('y')):(column('flag')) with filledcurves closed fc palette, \
     'data/implicit-rolling-40/domains_0001.csv' using (column('x')):(column('y')) with lines lc rgb '#aaaaaa' lw 1 dt solid, \
     'data/implicit-rolling-40/particles_0001.csv' using (column('x')):(column('y')) every 3 with dots lc rgb '#d55e00'
set size noratio
set origin 0,0
set size 0.5,0.56
set title 'path of the centre'
set xlabel 'time t [s]'
set ylabel 'path [m]'
set xrange [0:2.5]
set yrange [0:17]
set key top left Left reverse samplen 3
plot 'data/implicit-rolling-40/history.csv' using (column('t')):(column('path')) with lines lt 2 title 'J = 1', \
     'data/implicit-rolling-80/history.csv' using (column('t')):(column('path')) with lines lt 3 title 'J = 2', \
     'data/implicit-rolling-40/history.csv' using (column('t')):(column('path_exact')) with lines lt 1 title 'rigid, rolls'
set origin 0.5,0
set title 'relative to the rigid disk'
set ylabel 'path / exact - 1 [-]'
set yrange [-0.15:0.2]
set key bottom right
plot 'data/implicit-rolling-40/history.csv' using (column('t')):(column('path') / column('path_exact') - 1) with lines lt 2 title 'J = 1', \
     'data/implicit-rolling-80/history.csv' using (column('t')):(column('path') / column('path_exact') - 1) with lines lt 3 title 'J = 2', \
     0 with lines lt 1 lw 1 notitle
unset multiplot
