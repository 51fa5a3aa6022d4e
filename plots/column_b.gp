# Report figure 8: the bar under a step load against its series (70), and the error against the cell size.
load 'style.gnuplot'
set terminal pngcairo size 1500,640 font ',20'
set output 'column_b.png'
set multiplot layout 1,2 title 'Bar under a step load'
set key top center horizontal samplen 3
set title '32 cells, Lagrange functions of order 2, α = 0.5'
set xlabel 'time t [ms]'
set ylabel 'displacement of the end u(L) [mm]'
set xrange [0:0.2]
set yrange [-0.06:0.02]
set xtics 0.05
plot 'data/column-b/history.csv' using (column('t')):(column('u_end')) with lines lt 4 lw 6 title 'TLMPM', \
     'data/column-b/history.csv' using (column('t')):(column('u_end_exact')) with lines lt 1 dt (2,4) title 'exact'
set title 'rms error of u(L) over 3.6 periods'
set xlabel 'cell size h / L'
set ylabel 'rms error / |τ L/E|'
set key bottom right vertical Left reverse samplen 3
set logscale xy
set xtics ('1/128' 1./128, '1/64' 1./64, '1/32' 1./32, '1/16' 1./16, '1/8' 1./8)
set xrange [1./160:1./6.4]
set yrange [1e-4:0.2]
set format y '10^{%T}'
h(x) = 1 / column('cells')
plot 'data/column-b-report/summary.csv' using (h(0)):(column('error')) with linespoints lt 4 pt 7 ps 1.7 title 'order 2, α = 0.5', \
     'data/column-b-flip/summary.csv' using (h(0)):(column('error')) with linespoints lt 2 pt 5 ps 1.7 title 'hat, α = 1', \
     'data/column-b-fem/summary.csv' using (h(0)):(column('error')) with linespoints lt 3 pt 6 ps 2 title 'finite elements, hat', \
     'data/column-b-neo/summary.csv' using (h(0)):(column('error')) with linespoints lt 6 pt 9 ps 2 title 'order 2, neo-Hookean', \
     0.25 * x with lines lt 1 lw 1.5 dt (2,4) title 'order 1'
unset multiplot
