# Review 5.2: a cantilever in gravity. Deflection of its tip against time, its first peak against Poisson's ratio, and the noise of the pressure.
load 'style.gnuplot'
set terminal pngcairo size 1900,640 font ',19'
set output 'fbar_cantilever.png'
period = 2.723  # of the first mode at nu = 0.499 [s]
nus = '0.3 0.49 0.499 0.4999 0.49999'
peak(name) = sprintf('data/locking-%s/history.csv', name)
array off[5]; array moving[5]; array total[5]
do for [i=1:5] {
    stats peak('off-'.word(nus, i)) using (column('tip') / (2 * column('tip_static'))) nooutput
    off[i] = STATS_max
    stats peak('moving-'.word(nus, i)) using (column('tip') / (2 * column('tip_static'))) nooutput
    moving[i] = STATS_max
    stats peak('tlmpm-'.word(nus, i)) using (column('tip') / (2 * column('tip_static'))) nooutput
    total[i] = STATS_max
}
set multiplot layout 1,3 title 'Cantilever of 16 x 4 cells, 2 x 2 particles, hat functions, MUSL'
set title 'ν = 0.499'
set xlabel 'time t / period'
set ylabel 'deflection of the tip / (2 x at rest)'
set key top left Left reverse samplen 3
set xrange [0:0.7]
set yrange [0:1.45]
tip = "(column('t')/period):(column('tip')/(2*column('tip_static')))"
plot peak('off-0.499') using @tip with lines lt 1 title 'without F-bar', \
     peak('grid-0.499') using @tip with lines lt 2 title 'F-bar, cells of the grid', \
     peak('moving-0.499') using @tip with lines lt 4 title 'F-bar, moving cells', \
     peak('tlmpm-0.499') using @tip with lines lt 3 lw 4 title 'F-bar, total Lagrangian'
set title 'first peak'
set xlabel '1/2 - ν'
set ylabel 'deflection of the tip / (2 x at rest)'
set key at graph 0.97,0.86 right Left reverse samplen 2
set logscale x
set format x '10^{%T}'
set xrange [0.4:4e-6]
set yrange [0:1.1]
set xtics auto
x(i) = 0.5 - word(nus, int(i + 0.5))
set samples 5
plot sample [1:5] '+' using (x($1)):(moving[int($1 + 0.5)]) with linespoints lt 4 pt 7 ps 1.8 title 'moving cells', \
     [1:5] '+' using (x($1)):(total[int($1 + 0.5)]) with points pt 6 ps 2.6 lw 3 lc rgb '#0072b2' title 'total Lagrangian', \
     [1:5] '+' using (x($1)):(off[int($1 + 0.5)]) with linespoints lt 1 pt 5 ps 1.6 title 'without F-bar'
set title 'pressure noise between cells, ν = 0.499'
set xlabel 'time t / period'
set ylabel 'noise / rms pressure'
set key at graph 0.98,0.98 right top Left reverse samplen 2
unset logscale x
set format x '%g'
set xrange [0.1:0.7]
set logscale y
set yrange [1e-3:30]
set format y '10^{%T}'
noise = "(column('t')/period):(column('noise_between'))"
plot peak('grid-0.499') using @noise with lines lt 2 title 'F-bar, cells of the grid', \
     peak('moving-0.499') using @noise with lines lt 4 title 'F-bar, moving cells', \
     peak('tlmpm-0.499') using @noise with lines lt 3 lw 4 title 'F-bar, total Lagrangian'
unset multiplot
