# Newton's convergence: the residual over the size of its terms, some steps of the rolling disk and of the column that sinks.
load 'style.gnuplot'
set terminal pngcairo size 1100,700 font ',20'
set output 'implicit_newton.png'
set logscale y
set format y '10^{%L}'
set xlabel 'Newton iteration [-]'
set ylabel '|r| / size of its terms [-]'
set xrange [-0.2:4.6]
set xtics 1
set yrange [1e-17:2]
set title 'Newton converges quadratically down to rounding'
set key top right Left reverse samplen 3
step(n) = column('solution') == n ? column('residual') / column('terms') : NaN
plot for [n in '1 60 120 180 240'] 'data/implicit-rolling-40/newton.csv' using (column('iteration')):(step(n + 0)) with linespoints lt 3 pt 6 ps 1.6 lw 2 \
         title (n eq '1' ? 'rolling disk, 5 steps' : ''), \
     for [n = 0:3] 'data/implicit-column/newton.csv' using (column('iteration')):(step(n)) with linespoints lt 2 pt 7 ps 1.6 lw 2 \
         title (n == 0 ? 'column of E = 10^6, first 4' : '')
