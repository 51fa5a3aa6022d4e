# Review figures 21 and 22: the quadratic Bernstein polynomials of one cell, and the functions they make on three cells.
load 'style.gnuplot'
set terminal pngcairo size 1400,1000 font ',20'
set output 'basis_bernstein.png'
set multiplot title 'Quadratic Bernstein functions'
set key outside right top samplen 2
set xtics 0.5
set yrange [-0.05:1.05]
set size 0.5,0.46
set origin 0,0.48
set title 'one cell'
set xlabel 'ξ'
set ylabel 'B_{i,2}'
plot for [I=0:2] 'data/basis-bernstein-1/basis_1d.csv' using (column('x')):(column('bernstein_'.I)) with lines lt I+1 title sprintf('B_{%d,2}', I)
set origin 0.5,0.48
set title 'one cell, derivatives'
set ylabel 'dB_{i,2}/dξ'
set yrange [-2.2:2.2]
plot for [I=0:2] 'data/basis-bernstein-1/gradients_1d.csv' using (column('x')):(column('bernstein_'.I)) with lines lt I+1 title sprintf('B_{%d,2}', I)
set size 1,0.48
set origin 0,0
set title 'three cells: edges (even I) and middles (odd I)'
set xlabel 'x / h'
set ylabel 'φ_I'
set yrange [-0.05:1.05]
plot for [I=0:6] 'data/basis-bernstein/basis_1d.csv' using (column('x')):(column('bernstein_'.I)) with lines lt (I % 2 ? 2 : I % 4 ? 3 : 1) title sprintf('φ_%d', I)
unset multiplot
