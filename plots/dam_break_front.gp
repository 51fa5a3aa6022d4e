# Front of a column twice as high as long against time, in the variables of Martin and Moyce (1952), whose measurements (their figure 3,
# n^2 = 2, a = 2.25 inches) are shown, beside the shallow-water front on a dry bed. A hundred times the bulk modulus locks hat functions,
# not cubic ones.
load 'style.gnuplot'
set terminal pngcairo size 1200,900 font ',20'
set output 'dam_break_front.png'
$measured << EOD
0.832,1.217
1.219,1.474
1.997,2.292
2.547,2.995
3.345,4.134
EOD
set title 'Dam break, h_0 = 2 l_0, 40 x 40 cells of l_0/8'
set xlabel 'T = t (g h_0)^{1/2}/l_0'
set ylabel 'front Z = x/l_0'
set xrange [0:3.2]
set yrange [1:5]
set key top left Left reverse samplen 4
file(s) = 'data/dam-front-'.s.'/history.csv'
plot 1 + 2*x with lines lw 2 lc rgb '#808080' dt (4,4) title 'shallow water, 1 + 2 T', \
     file('hat') using (column('T')):(column('Z')) with lines lt 1 title 'hat, κ = 1.2 MPa', \
     file('hat-stiff') using (column('T')):(column('Z')) with lines lt 2 title 'hat, κ = 120 MPa', \
     file('cubic') using (column('T')):(column('Z')) with lines lt 3 title 'cubic, κ = 1.2 MPa', \
     file('cubic-stiff') using (column('T')):(column('Z')) with lines lt 5 title 'cubic, κ = 120 MPa', \
     $measured using 1:2 with points pt 7 ps 1.6 lc rgb '#000000' title 'Martin and Moyce 1952'
