# Review figure 74: convergence of the TLMPM on the generalized vortex, and why it slows down there: e_2 (A.13) against the cell size. Left: the printed setting
# and, open, the better one. Right: cubic functions, one setting after the other: the body force on the nodes costs most on fine grids, then the lumped mass;
# half the time step changes nothing.
load 'style.gnuplot'
set terminal pngcairo size 1500,800 font ',19'
set output 'vortex_error.png'
set datafile missing NaN
set multiplot layout 1,2 title 'TLMPM on the generalized vortex: error of the displacement against the cell size'
file(name) = 'data/vortex-'.name.'/summary.csv'
e2(x) = stringcolumn('error_name') eq 'e2' ? x : NaN
set logscale xy
set dummy h
set xlabel 'cell size h [length]'
set ylabel 'e_2 [-]' offset 0.5,0
set xrange [0.0105:0.062]
set xtics (0.0125, 0.025, 0.05)
set yrange [8e-4:0.9]
set format y '10^{%T}'
set lmargin 9
set rmargin 1.5
set key top left Left reverse samplen 3 font ',17'
set title 'printed setting, and better'
set label 1 'order 2' at 0.037,1.4e-3 tc rgb '#606060'
plot 1.6*h**2 with lines lc rgb '#606060' lw 2 dt (4,4) notitle, \
     file('printed-hat') using (column('h')):(e2(column('error'))) with linespoints lw 2.5 dt (8,3) lc rgb '#d55e00' pt 7 ps 1.5 title 'hat, as printed', \
     file('printed-cubic') using (column('h')):(e2(column('error'))) with linespoints lw 2.5 dt (8,3) lc rgb '#0072b2' pt 5 ps 1.5 title 'cubic, as printed', \
     file('cubic') using (column('h')):(e2(column('error'))) with linespoints lw 2.5 dt solid lc rgb '#0072b2' pt 4 ps 1.7 title 'cubic, better', \
     file('printed-bernstein') using (column('h')):(e2(column('error'))) with linespoints lw 2.5 dt (8,3) lc rgb '#009e73' pt 9 ps 1.5 title 'Bernstein, as printed', \
     file('bernstein') using (column('h')):(e2(column('error'))) with linespoints lw 2.5 dt solid lc rgb '#009e73' pt 8 ps 1.7 title 'Bernstein, better'
set title 'cubic functions: what costs the accuracy'
plot 1.6*h**2 with lines lc rgb '#606060' lw 2 dt (4,4) notitle, \
     file('printed-cubic') using (column('h')):(e2(column('error'))) with linespoints lw 2.5 dt (8,3) lc rgb '#0072b2' pt 5 ps 1.5 title 'as printed', \
     file('steps') using (column('h')):(e2(column('error'))) with linespoints lw 1.5 dt (2,3) lc rgb '#000000' pt 2 ps 1.8 title 'half the time step', \
     file('particles') using (column('h')):(e2(column('error'))) with linespoints lw 2.5 dt (8,3,2,3) lc rgb '#e69f00' pt 13 ps 1.7 title 'body force at the particles', \
     file('cubic') using (column('h')):(e2(column('error'))) with linespoints lw 2.5 dt solid lc rgb '#0072b2' pt 4 ps 1.7 title 'and α = 1, cut particles', \
     file('fmpm') using (column('h')):(e2(column('error'))) with linespoints lw 2.5 dt (14,3) lc rgb '#cc79a7' pt 11 ps 1.7 title 'and FMPM(5), not lumped'
unset multiplot
