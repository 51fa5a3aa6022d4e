# The full order of the basis: total-Lagrangian MPM with the consistent mass matrix, particles at Gauss points, time step 0.01 h/c.
load 'style.gnuplot'
set terminal pngcairo size 1100,800 font ',18'
set output 'mms_order.png'
set datafile missing NaN
set title 'Consistent mass on the manufactured segment, G = 10^{-4}, Δt = 0.01 h/c'
set xlabel 'cell size h [length]'
set ylabel 'e_1 [length]'
set logscale x 2
set logscale y
set format x '2^{%L}'
set format y '10^{%T}'
set xrange [2**-5.4:2**-1.6]
set yrange [1e-12:1e-3]
set key bottom right Left reverse samplen 3
e1(x) = stringcolumn('error_name') eq 'e1' ? x : NaN
file(name) = 'data/order-'.name.'/summary.csv'
set label 1 'order 4' at 2**-4.0,4e-11 textcolor rgb '#606060'
set label 2 'order 2' at 2**-4.6,1.1e-6 textcolor rgb '#606060'
plot file('lumped') using (column('h')):(e1(column('error'))) with linespoints lt 4 pt 13 ps 1.5 title 'cubic, FLIP (lumped mass)', \
     file('fem') using (column('h')):(e1(column('error'))) with linespoints lt 1 pt 5 ps 1.5 title 'finite elements, linear, lumped', \
     file('hat') using (column('h')):(e1(column('error'))) with linespoints lt 3 pt 7 ps 1.5 title 'hat, consistent: order 2', \
     file('bernstein') using (column('h')):(e1(column('error'))) with linespoints lt 5 pt 11 ps 1.5 title 'Bernstein, consistent: order 3', \
     file('cubic') using (column('h')):(e1(column('error'))) with linespoints lt 2 pt 9 ps 1.5 title 'cubic, consistent: order 4', \
     [2**-4.5:2**-2.5] 3e-5*x**4*0.4 with lines lt 1 lw 1 lc rgb '#606060' notitle, \
     [2**-5:2**-3] 2.5e-4*x**2 with lines lt 1 lw 1 lc rgb '#606060' notitle
