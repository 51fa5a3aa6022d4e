# Error against run time: the manufactured segment. Drawn in a folder of figures.
load 'style.gnuplot'
set terminal pngcairo size 640,520 font ',19'
set output 'readme_cost.png'
set title 'Error and cost: a segment'
set xlabel 'CPU time [s]' offset 0,0.3
set ylabel 'rms error e1 [length]'
set logscale
set format '10^{%T}'
set xrange [1e-4:0.2]
set yrange [1e-7:0.1]
set ytics 100
set key below vertical maxrows 3 samplen 1.5 width -2 Left reverse font ',17'
set bmargin 7
# Variants by their numbers in plots/runs/compared.sh.
who(number) = column('variant') == number ? column('seconds') : NaN
csv = 'data/segment/errors.csv'
plot 'data/segment/front.csv' using (column('seconds')):(column('error')) with lines lw 10 lc rgb '#dcdcdc' title 'beaten by none', \
     csv using (who(9)):(column('error')) with linespoints lt 2 pt 8 ps 1.3 title 'USL, hat', \
     csv using (who(3)):(column('error')) with linespoints lt 3 pt 6 ps 1.3 title 'TLMPM, hat', \
     csv using (who(1)):(column('error')) with linespoints lt 1 pt 5 ps 1.1 title 'linear FEM', \
     csv using (who(2)):(column('error')) with linespoints lt 4 pt 4 ps 1.3 title 'quadratic FEM', \
     csv using (who(8)):(column('error')) with linespoints lt 6 pt 7 ps 1.3 title 'TLMPM, consistent'
