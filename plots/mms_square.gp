# Review figure 70: convergence of the TLMPM on the manufactured square, small and large amplitude: e_1 (A.12) and e_2 (A.13) against the cell size. Dotted: the
# printed setting, whose body force acts on the nodes and whose velocities hold one part in a hundred of PIC (alpha = 0.99).
load 'style.gnuplot'
set terminal pngcairo size 1700,850 font ',19'
set output 'mms_square.png'
set datafile missing NaN
shapes = 'hat cubic bernstein'
array names[3] = ['hat', 'cubic', 'Bernstein']
array colours[3] = [0xd55e00, 0x0072b2, 0x009e73]
array filled[3] = [7, 5, 9]
file(i, setting) = 'data/square-'.sprintf(setting, word(shapes, i)).'/summary.csv'
e(name, x) = stringcolumn('error_name') eq name ? x : NaN

set multiplot title 'TLMPM on the manufactured square: error of the displacement against the cell size'
set size 1,0.11  # one legend for all
set origin 0,0.83
set tmargin 0
set bmargin 0
unset border
unset tics
set key vertical maxrows 3 center center Left reverse samplen 3 width -8 font ',18'
set yrange [0:1]
plot for [i=1:3] NaN with linespoints lw 2.5 dt solid lc rgb colours[i] pt filled[i] ps 1.5 title names[i].', G = 0.05', \
     for [i=1:3] NaN with linespoints lw 2.5 dt (8,3) lc rgb colours[i] pt filled[i]-1 ps 1.5 title names[i].', G = 10^{-4}  ', \
     for [i=1:3] NaN with linespoints lw 2.5 dt (2,3) lc rgb colours[i] pt 2 ps 1.3 title names[i].', G = 0.05, as printed'
set border
set tics
unset key
set size 1.0/3,0.83
set lmargin 9
set tmargin 2
set bmargin 3.5
set rmargin 1
set logscale xy
set dummy h
set xlabel 'cell size h [length]'
set xrange [1.0/90:0.17]
set xtics ('2^{-6}' 2**-6.0, '2^{-5}' 2**-5.0, '2^{-4}' 2**-4.0, '2^{-3}' 2**-3.0)
set format y '10^{%T}'
do for [k=1:3] {
    name = k == 1 ? 'e1' : 'e2'
    p = k == 3 ? 2 : 0  # divided by h^p
    set origin (k-1)/3.0,0
    set title (k == 1 ? 'largest error in time' : k == 2 ? 'relative error over time' : 'divided by h^2: level is order 2')
    set ylabel (k == 1 ? 'e_1 [length]' : k == 2 ? 'e_2 [-]' : 'e_2 / h^2 [1/length^2]') offset 0.5,0
    low = k == 1 ? 5e-8 : k == 2 ? 3e-4 : 2
    high = k == 1 ? 3e-2 : k == 2 ? 0.3 : 15
    if (k == 3) { set format y '%g'; set ytics (2, 3, 4, 5, 7, 10, 15) }
    s = k == 1 ? 1.2e-2 : 1.2  # the guide, s h^2, lies below all curves or between the two amplitudes
    set yrange [low:high]
    unset label
    if (k < 3) { set label 1 'order 2' at k == 1 ? 0.0125 : 0.03,(k == 1 ? 9e-6 : 4.2e-4) tc rgb '#606060' }
    plot (k < 3 ? s*h**2 : NaN) with lines lc rgb '#606060' lw 2 dt (4,4), \
         for [i=1:3] file(i, '%s-0.05') using (column('h')):(e(name, column('error')/column('h')**p)) \
             with linespoints lw 2.5 dt solid lc rgb colours[i] pt filled[i] ps 1.5, \
         for [i=1:3] file(i, '%s-1e-4') using (column('h')):(e(name, column('error')/column('h')**p)) \
             with linespoints lw 2.5 dt (8,3) lc rgb colours[i] pt filled[i]-1 ps 1.5, \
         for [i=1:3] file(i, 'printed-%s') using (column('h')):(e(name, column('error')/column('h')**p)) \
             with linespoints lw 2.5 dt (2,3) lc rgb colours[i] pt 2 ps 1.3
}
unset multiplot
