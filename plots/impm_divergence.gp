# Why the iMPM as printed diverges on fine grids (review figure 69): largest error of the segment against the cell size, as printed and mended; growth of noise on
# the particles in one period; and growth rates of an endless bar at rest whose particles lie off the middle. Grids finer than 1/512: plots/impm_fine.csv, measured
# once in steps of 0.2 h/c, as by `mms_segment --scheme impm --ppc 2 --limit 1e4 --cfl 0.2765 (G = 1e-4: 0.2325) --cells 1024,2048,4096`: 3 minutes a row of 4096.
load 'style.gnuplot'
set terminal pngcairo size 1700,720 font ',18'
set output 'impm_divergence.png'
set datafile missing NaN
set linetype 11 lc rgb '#0072b2' lw 2.5 dt solid pt 7
set linetype 12 lc rgb '#56b4e9' lw 2.5 dt (8,3) pt 6
set linetype 13 lc rgb '#d55e00' lw 2.5 dt solid pt 9
set linetype 14 lc rgb '#e69f00' lw 2.5 dt (8,3) pt 8
set linetype 15 lc rgb '#cc79a7' lw 2.5 dt (2,4) pt 10
fine = 'impm_fine.csv'
e1(x) = stringcolumn('error_name') eq 'e1' ? x : NaN
row(g, s, G) = stringcolumn('gradient') eq g && abs(column('support') - s) < 0.01 && abs(column('G') / G - 1) < 0.01 ? column('e1') : NaN
set multiplot layout 1,3 title 'The improved MPM: gradient at the particles as printed (of the hat functions) and mended (linear between cells)'
set key at graph 0.99,0.02 bottom right Left reverse samplen 2 font ',15' width -3
set logscale xy
set xlabel 'cell size h [length]'
set ylabel 'e_1 [length]' offset 0.5,0
set xrange [2**-12.6:0.2]
set xtics ('2^{-12}' 2**-12.0, '2^{-10}' 2**-10.0, '2^{-8}' 2**-8.0, '2^{-6}' 2**-6.0, '2^{-4}' 2**-4.0)
set format y '10^{%T}'
set yrange [1e-15:0.1]
set title 'manufactured segment'
set label 1 'G = 0.05' at 2**-8.6,3e-4
set label 2 'G = 10^{-4}' at 2**-6.6,8e-9
plot 'data/impm-linear-1.1-0.05/summary.csv' using (column('h')):(e1(column('error'))) with linespoints lt 11 ps 1.4 title 'mended, d = 1.1 h', \
     fine using (column('h')):(row('linear', 1.1, 0.05)) with linespoints lt 11 ps 1.4 notitle, \
     'data/impm-linear-1.1-1e-4/summary.csv' using (column('h')):(e1(column('error'))) with linespoints lt 12 ps 1.4 title 'the same, small G', \
     fine using (column('h')):(row('linear', 1.1, 1e-4)) with linespoints lt 12 ps 1.4 notitle, \
     'data/impm-hat-1.1-0.05/summary.csv' using (column('h')):(e1(column('error'))) with linespoints lt 13 ps 1.4 title 'printed, d = 1.1 h', \
     'data/impm-hat-1.5-0.05/summary.csv' using (column('h')):(e1(column('error'))) with linespoints lt 14 ps 1.4 title 'printed, d = 1.5 h', \
     fine using (column('h')):(row('hat', 1.5, 0.05)) with linespoints lt 14 ps 1.4 notitle, \
     fine using (column('h')):(row('hat', 1.5, 1e-4)) with linespoints lt 15 ps 1.4 title 'the same, small G', \
     [2**-12:2**-4] 0.1*x**2 with lines lw 2 dt (4,4) lc rgb '#606060' title 'order 2'
unset label
set title 'noise of 10^{-10}, G = 0.05'
set ylabel 'largest growth in a period [-]'
set xrange [2**-9.4:2**-4.6]
set xtics ('2^{-9}' 2**-9.0, '2^{-8}' 2**-8.0, '2^{-7}' 2**-7.0, '2^{-6}' 2**-6.0, '2^{-5}' 2**-5.0)
set yrange [0.5:1e10]
set key default
set key top right Left reverse samplen 2
plot for [d in '1.01 1.1 1.5'] 'data/impm-noise-'.d.'/noise.csv' using (column('h')):(column('hat')) \
         with linespoints lt (d eq '1.01' ? 15 : d eq '1.1' ? 13 : 14) ps 1.4 title 'printed, d = '.d.' h', \
     'data/impm-noise-1.1/noise.csv' using (column('h')):(column('linear')) with linespoints lt 11 ps 1.4 title 'mended, d = 1.1 h'
unset logscale
set format y '%g'
set title 'theory: bar at rest'
set xlabel 'offset [cells]'
set ylabel 'growth rate of the fastest wave [c/h]'
set xrange [0:0.25]
set xtics 0,0.05,0.25
set yrange [-0.01:0.14]
set key top left
plot for [d in '1.5 1.1 1.01'] 'data/impm-noise-'.d.'/theory.csv' using (column('offset')):(column('rate_hat')) \
         with lines lt (d eq '1.01' ? 15 : d eq '1.1' ? 13 : 14) title 'printed, d = '.d.' h', \
     'data/impm-noise-1.1/theory.csv' using (column('offset')):(column('rate_linear')) with lines lt 11 title 'mended, any d'
unset multiplot
