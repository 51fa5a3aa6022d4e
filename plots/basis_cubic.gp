# Review figure 20: the cubic B-splines of five cells, as many functions as nodes. Curves of one type share colour and dash.
load 'style.gnuplot'
set terminal pngcairo size 1400,1000 font ',20'
set output 'basis_cubic.png'
set multiplot layout 2,1 title 'Cubic B-splines of five cells'
set key outside right top Left reverse samplen 2
set xlabel 'x / h'
set xtics 1
type(I) = I == 0 || I == 5 ? 1 : I == 1 ? 2 : I == 4 ? 4 : 3
name(I) = I == 0 ? 'φ_0, φ_5: type 1' : I == 1 ? 'φ_1: type 2' : I == 2 ? 'φ_2, φ_3: type 3' : I == 4 ? 'φ_4: type 4' : ''
set ylabel 'φ_I'
set yrange [-0.05:1.05]
plot for [I=0:5] 'data/basis-cubic/basis_1d.csv' using (column('x')):(column('cubic_'.I)) with lines lt type(I) title name(I)
set ylabel 'h dφ_I/dx'
set yrange [-1.1:1.1]
plot for [I=0:5] 'data/basis-cubic/gradients_1d.csv' using (column('x')):(column('cubic_'.I)) with lines lt type(I) title name(I)
unset multiplot
