# Implicit bar: frequency against the exact one and against the closed form of Newmark's rule, for steps from 0.1 to 1000 h/c.
load 'style.gnuplot'
set datafile missing NaN
set terminal pngcairo size 1500,620 font ',20'
set output 'implicit_bar.png'
set multiplot layout 1,2 title 'Implicit MPM: vibration of a bar, 50 cells' margins 0.09,0.98,0.15,0.80 spacing 0.11
set logscale xy
set format '10^{%L}'
set xlabel 'time step / (h/c) [-]'
set xrange [0.05:2000]
set key bottom right Left reverse samplen 3
file(mode, beta) = sprintf("< cat data/implicit-bar-%s-%s-*/summary.csv", mode, beta)
error(name) = strcol('error_name') eq name ? column('error') : NaN
set title 'against the exact frequency'
set ylabel '|frequency / exact - 1| [-]'
set yrange [1e-8:2]
plot for [i = 1:2] for [j = 1:2] file(word('1 10', i), word('0.25 0.3', j)) using (column('cfl')):(error('frequency')) \
     with linespoints lt 1 + 2 * (i - 1) + j pt 4 + 2 * i + j ps 1.6 title sprintf('mode %s, β = %s', word('1 10', i), word('1/4 0.3', j))
set title 'against the closed form of Newmark''s rule'
set ylabel '|frequency / Newmark''s - 1| [-]'
set yrange [1e-17:1e-2]
set arrow 1 from 0.05,1e-6 to 10,1e-6 nohead lw 2 lc rgb '#999999'
set arrow 2 from 10,2e-4 to 2000,2e-4 nohead lw 2 lc rgb '#999999'
set label 1 'asked for' at 0.07,4e-6 tc rgb '#666666'
unset key
plot for [i = 1:2] for [j = 1:2] file(word('1 10', i), word('0.25 0.3', j)) using (column('cfl')):(error('newmark_frequency')) \
     with linespoints lt 1 + 2 * (i - 1) + j pt 4 + 2 * i + j ps 1.6 notitle
unset multiplot
