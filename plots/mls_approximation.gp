# Review figures 98 and 99: a linear function at random points, brought to nodes by moving least squares with constant (Shepard) and linear basis; and the
# error of sin(pi x) against the cell size. Cubic spline weight, support 2 h.
load 'style.gnuplot'
set terminal pngcairo size 1500,560 font ',18'
set output 'mls_approximation.png'
set datafile missing NaN
set multiplot layout 1,3 title 'Moving least squares from random points (grey) to the nodes, support 2 h'
set xlabel 'x [length]'
set ylabel 'u [-]'
set key top left Left reverse samplen 2
set xrange [-0.03:1.03]
set yrange [0.95:2.15]
array column_of[2] = ['u_shepard', 'u_linear']
array name[2] = ['constant basis (Shepard)', 'linear basis']
do for [k=1:2] {
    set title 'u = 1 + x, '.name[k]
    plot 1+x with lines lt 1 lw 1.5 title 'u = 1 + x', \
         'data/mls-linear/points.csv' using (column('x')):(column('u')) with points pt 7 ps 1.3 lc rgb '#999999' title '15 points', \
         'data/mls-linear/nodes.csv' using (column('x')):(column(column_of[k])) with points pt 6 ps 2 lw 2.5 lc rgb (k == 1 ? '#d55e00' : '#0072b2') title '11 nodes'
}
set title 'u = sin πx, 2 points per cell'
set xlabel 'cell size h [length]'
set ylabel 'rms error of the nodes [-]'
set logscale xy
set xrange [0.005:0.062]
set xtics ('1/160' 1.0/160, '1/80' 1.0/80, '1/40' 1.0/40, '1/20' 1.0/20)
set yrange [3e-10:0.3]
set format y '10^{%T}'
set key bottom right Left reverse samplen 2.5
e(basis) = stringcolumn('basis') eq basis ? column('l2') : NaN
set label 1 'order 2' at 0.0063,1.3e-3 tc rgb '#606060'
plot 'data/mls-sine/convergence.csv' using (column('h')):(e('shepard')) with linespoints lt 2 pt 4 ps 1.6 title 'constant', \
     '' using (column('h')):(e('linear')) with linespoints lt 3 pt 6 ps 1.6 title 'linear', \
     '' using (column('h')):(e('quadratic')) with linespoints lt 5 pt 8 ps 1.6 title 'quadratic', \
     [0.00625:0.05] 3.4*x**2 with lines lw 1.5 dt (4,4) lc rgb '#606060' notitle
unset multiplot
