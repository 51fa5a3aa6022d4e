# A pulse crosses the joint of a bar of finite elements (x < 1/2) and one of particles: velocities at the end, and the error with the cells.
load 'style.gnuplot'
set terminal pngcairo size 1500,1250 font ',20'
set output 'coupled_bar.png'
set multiplot title 'A pulse crosses the joint (x = 0.5) of a finite element bar and an implicit MPM bar, 200 cells'
v0 = 1e-4
set xlabel 'x [length]'
set ylabel 'velocity / v_0 [-]'
set xrange [0:1]
set key top left Left reverse samplen 3
set arrow 1 from 0.5,graph 0 to 0.5,graph 1 nohead lc rgb '#888888' lw 1
set origin 0,0.48
set size 0.5,0.48
set title '4 E in particles: R = -1/3, T = 2/3'
set yrange [-0.6:1.8]
plot 'data/coupled-bar-stiff/particles_0000.csv' using (column('x')):(column('v')/v0) with lines lt 3 title 'start', \
     'data/coupled-bar-stiff/particles_0002.csv' using (column('x')):(column('body') == 1 ? column('v')/v0 : 1/0) with lines lt 1 title 'end, finite elements', \
     'data/coupled-bar-stiff/particles_0002.csv' using (column('x')):(column('body') == 0 ? column('v')/v0 : 1/0) with lines lt 2 title 'end, particles', \
     2.0/3 with lines lc rgb '#888888' lw 1 dt 3 notitle, -1.0/3 with lines lc rgb '#888888' lw 1 dt 3 notitle
set origin 0.5,0.48
set title 'from particles to E/10: R = 0.519, T = 1.519'
set yrange [-0.2:2.4]
set key top right
set arrow 1 from 0.5,graph 0 to 0.5,graph 1 nohead lc rgb '#888888' lw 1
R = (1 - sqrt(0.1))/(1 + sqrt(0.1))
plot 'data/coupled-bar-soft/particles_0000.csv' using (column('x')):(column('v')/v0) with lines lt 3 title 'start', \
     'data/coupled-bar-soft/particles_0002.csv' using (column('x')):(column('body') == 1 ? column('v')/v0 : 1/0) with lines lt 1 title 'end, finite elements', \
     'data/coupled-bar-soft/particles_0002.csv' using (column('x')):(column('body') == 0 ? column('v')/v0 : 1/0) with lines lt 2 title 'end, particles', \
     1 + R with lines lc rgb '#888888' lw 1 dt 3 notitle, R with lines lc rgb '#888888' lw 1 dt 3 notitle
unset arrow 1
set origin 0.15,0
set size 0.7,0.48
set title 'equal bars: the coupled one lies between its two kinds'
set xlabel 'cells'
set ylabel 'relative L2 error of the velocity [-]'
set logscale xy
set xrange [40:250]
set yrange [1e-3:0.1]
set xtics (50, 100, 200)
set format y '10^{%L}'
set key top right
plot 'data/coupled-bar-coupled/summary.csv' using (column('cells')):(column('error')) every 3 with linespoints lt 1 pt 7 ps 1.5 title 'coupled', \
     'data/coupled-bar-fem/summary.csv' using (column('cells')):(column('error')) every 3 with linespoints lt 2 pt 5 ps 1.5 title 'finite elements alone', \
     'data/coupled-bar-mpm/summary.csv' using (column('cells')):(column('error')) every 3 with linespoints lt 3 pt 9 ps 1.5 title 'particles alone', \
     40/x**2 with lines lc rgb '#888888' lw 1 title 'slope 2'
unset multiplot
