# Review figure 11: the hat functions of three cells, and their gradients.
load 'style.gnuplot'
set terminal pngcairo size 1400,520 font ',20'
set output 'basis_hat.png'
set multiplot layout 1,2 title 'Hat functions of three cells'
set key outside right top samplen 1.5
set xlabel 'x / h'
set xtics 1
set ylabel 'φ_I'
set yrange [-0.05:1.05]
plot for [I=0:3] 'data/basis-hat/basis_1d.csv' using (column('x')):(column('hat_'.I)) with lines lt I+1 title sprintf('φ_%d', I)
set ylabel 'h dφ_I/dx'
set yrange [-1.2:1.2]
plot for [I=0:3] 'data/basis-hat/gradients_1d.csv' using (column('x')):(column('hat_'.I)) with lines lt I+1 title sprintf('φ_%d', I)
unset multiplot
