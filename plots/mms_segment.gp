# Review figure 69: convergence on the manufactured unit segment, small and large amplitude: largest error in time, e_1 (A.12), against the cell size. Ringed:
# the run reported an instability. Crossing a cell, or merely moving within it, is what stops the updated-Lagrangian schemes.
load 'style.gnuplot'
set terminal pngcairo size 1500,900 font ',19'
set output 'mms_segment.png'
set datafile missing NaN
variants = 'fem tlmpm-hat tlmpm-cubic tlmpm-bernstein musl-hat usf-hat usl-ugimp usl-cpgimp musl-cpgimp usl-cubic'
array names[10] = ['FEM, linear', 'TLMPM, hat', 'TLMPM, cubic', 'TLMPM, Bernstein', 'MUSL, hat', 'USF, hat', 'USL, uGIMP', 'USL, cpGIMP', 'MUSL, cpGIMP', 'USL, cubic']
# One colour for each family; its members differ in dash and symbol.
set linetype 11 lc rgb '#000000' lw 2.5 dt solid pt 5
set linetype 12 lc rgb '#0072b2' lw 2.5 dt solid pt 7
set linetype 13 lc rgb '#0072b2' lw 2.5 dt (8,3) pt 6
set linetype 14 lc rgb '#0072b2' lw 2.5 dt (2,4) pt 4
set linetype 15 lc rgb '#d55e00' lw 2.5 dt solid pt 9
set linetype 16 lc rgb '#d55e00' lw 2.5 dt (8,3) pt 8
set linetype 17 lc rgb '#e69f00' lw 2.5 dt solid pt 13
set linetype 18 lc rgb '#009e73' lw 2.5 dt solid pt 11
set linetype 19 lc rgb '#009e73' lw 2.5 dt (8,3) pt 10
set linetype 20 lc rgb '#cc79a7' lw 2.5 dt (8,3,2,3) pt 15
file(i, G) = 'data/segment-'.word(variants, i).'-'.G.'/summary.csv'
e1(x) = stringcolumn('error_name') eq 'e1' ? x : NaN
ring(x) = stringcolumn('error_name') eq 'e1' && stringcolumn('verdict') ne 'ok' ? 3 : 0

set multiplot title 'Manufactured unit segment: largest error of the displacement in time against the cell size'
set size 1,0.09  # one legend for both
set origin 0,0.85
set tmargin 0
set bmargin 0
unset border
unset tics
set key vertical maxrows 2 center center Left reverse samplen 2.5 width -2 font ',18'
set yrange [0:1]
plot for [i=1:10] NaN with linespoints lt 10+i ps 1.5 title names[i]
set border
set tics
unset key
set size 0.5,0.84
set lmargin 9
set tmargin 2
set bmargin 3.5
set rmargin 1.5
set logscale xy
set dummy h
set xlabel 'cell size h [length]'
set ylabel 'e_1 [length]' offset 0.5,0
set xrange [1.0/700:0.35]
set format y '10^{%T}'
set xtics ('2^{-9}' 2**-9.0, '2^{-8}' 2**-8.0, '2^{-7}' 2**-7.0, '2^{-6}' 2**-6.0, '2^{-5}' 2**-5.0, '2^{-4}' 2**-4.0, '2^{-3}' 2**-3.0, '2^{-2}' 0.25)
do for [k=1:2] {
    G = word('1e-4 0.05', k)
    set origin 0.5*(k-1),0
    set title k == 1 ? 'small displacements: G = 10^{-4}' : 'large displacements: G = 0.05'
    low = k == 1 ? 2e-10 : 1e-7
    high = k == 1 ? 1e-4 : 0.5
    s = k == 1 ? 4e-5 : 2e-2  # e_1 = s h^2 below all curves
    set yrange [low:high]
    set label 1 'order 2' at 0.1,s*0.1**2*0.45 tc rgb '#606060'
    set label 2 (k == 1 ? '2.5 G^2' : '') at 0.0016,3.4e-8 tc rgb '#d55e00'
    plot s*h**2 with lines lc rgb '#606060' lw 2 dt (4,4), \
         (k == 1 ? 2.5e-8 : 1e-9) with lines lc rgb '#d55e00' lw 2 dt (4,4), \
         for [i=1:10] file(i, G) using (column('h')):(e1(column('error'))) with linespoints lt 10+i ps 1.4, \
         for [i=1:10] file(i, G) using (column('h')):(column('error')):(ring(0)) with points lt 10+i lw 1.5 pt 6 ps variable
}
unset multiplot
