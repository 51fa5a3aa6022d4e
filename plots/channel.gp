# Couette and Poiseuille flow started from rest: particles (hat functions, 16 cells) beside the exact series, and errors against the cell
# size.
load 'style.gnuplot'
set terminal pngcairo size 1700,720 font ',20'
set output 'channel.png'
couette(y, t) = y + sum [n=1:40] 2/(n*pi)*(-1)**n*sin(n*pi*y)*exp(-(n*pi)**2*t)
poiseuille(y, t) = 4*y*(1 - y) - sum [n=0:20] 32/((2*n+1)*pi)**3*sin((2*n+1)*pi*y)*exp(-((2*n+1)*pi)**2*t)
set multiplot title 'Flow between two plates, started from rest'
set tmargin 3.5
set size 0.33,0.93
set samples 400
do for [k=1:2] {
    flow = word('couette poiseuille', k)
    set origin 0.333*(k-1),0
    set title k == 1 ? 'Couette: ν t/H^2 = 0.05, 0.1, 0.15, 0.2' : 'Poiseuille: the same times'
    set xlabel 'height y/H'
    set ylabel 'velocity v/U'
    unset key
    set xrange [0:1]
    set yrange [0:1.02]
    plot for [i=1:4] (k == 1 ? couette(x, 0.05*i) : poiseuille(x, 0.05*i)) with lines lc rgb '#000000' lw 1.5 dt solid, \
         for [i=1:4] sprintf('data/channel-%s/particles_%04d.csv', flow, i) using (column('y')):(column('vx')) with points pt 6 ps 0.8 lc rgb '#d55e00'
}
set origin 0.666,0
set title 'errors at ν t/H^2 = 0.1'
set logscale xy
set xlabel 'cell size h/H'
set ylabel 'rms error of velocity / U'
set xrange [0.025:0.3]
set yrange [1e-4:0.3]
set format y '10^{%T}'
set xtics ('1/32' 1/32.0, '1/16' 1/16.0, '1/8' 1/8.0, '1/4' 0.25)
set key top left Left reverse samplen 3 font ',17'
rms(x) = stringcolumn('error_name') eq 'v_rms' ? x : NaN
set datafile missing NaN
file(f, s) = 'data/channel-'.f.'-'.s.'/summary.csv'
set label 1 'order 2' at 0.1,0.0007 tc rgb '#606060'
plot 0.12*x**2 with lines lc rgb '#606060' lw 2 dt (4,4) notitle, \
     for [k=1:4] file(word('couette poiseuille couette poiseuille', k), word('hat hat cubic cubic', k)) using (column('h')):(rms(column('error'))) \
         with linespoints lt k pt 3+2*k ps 1.4 title word('Couette Poiseuille Couette Poiseuille', k).', '.word('hat hat cubic cubic', k)
unset multiplot
