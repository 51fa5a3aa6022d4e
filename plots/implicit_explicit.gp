# Explicit against implicit: error of the frequency against run time of one period, as the stiffness of the bar's outer half grows.
load 'style.gnuplot'
set datafile missing NaN
set terminal pngcairo size 1500,700 font ',20'
set output 'implicit_explicit.png'
set multiplot layout 1,3 title 'Bar with an outer half of other stiffness: error against run time, 8 to 64 cells' margins 0.11,0.98,0.16,0.74 spacing 0.03
set logscale xy
set format '10^{%L}'
set xrange [5e-5:1]
set yrange [1e-5:3e-2]
set xlabel 'CPU time of one period [s]'
set ylabel '|frequency / exact - 1| [-]'
do for [i = 1:3] {
    c = word('1 1e4 1e6', i)
    set title sprintf('outer half stiffer by %s', word('1 10^4 10^6', i))
    if (i > 1) { unset ylabel; set format y '' }
    if (i == 1) { set key at screen 0.5,0.9 center maxrows 1 samplen 3 } else { unset key }
    error(x) = strcol('error_name') eq 'frequency' ? column('error') : NaN
    plot 'data/implicit-contrast-'.c.'/summary.csv' using (column('cpu_s')):(error(0)) with linespoints lt 1 pt 7 ps 1.8 title 'implicit, 200 steps', \
         'data/musl-contrast-'.c.'/summary.csv' using (column('cpu_s')):(error(0)) with linespoints lt 2 pt 6 ps 1.8 title 'MUSL', \
         'data/tlmpm-contrast-'.c.'/summary.csv' using (column('cpu_s')):(error(0)) with linespoints lt 3 pt 4 ps 1.8 title 'TLMPM'
}
unset multiplot
