# L1 errors of Sod's shock tube against the cell size, at nodes and particles: smooth functions converge by first order, which is all that
# a jump allows, hat functions do not.
load 'style.gnuplot'
set terminal pngcairo size 1500,800 font ',20'
set output 'shock_tube_order.png'
set datafile missing NaN
shapes = 'hat cpgimp cubic'
array names[3] = ['hat', 'cpGIMP', 'cubic']
array kinds[2] = ['density', 'internal energy']
fields = 'rho e'
l1(name) = stringcolumn('error_name') eq name ? column('error') : NaN
file(k) = 'data/sod-order-'.word(shapes, k).'/summary.csv'
set multiplot layout 1,2 title "Sod's shock tube, 100 to 1200 cells: mean error over the tube (L_1)"
set logscale xy
set xlabel 'cell size h / length of the tube'
set xrange [6e-4:0.014]
set format y '10^{%T}'
set xtics (0.001, 0.002, 0.005, 0.01)
set key top left Left reverse samplen 3
do for [f=1:2] {
    set title kinds[f]
    set ylabel f == 1 ? 'L_1 error [mass/length]' : 'L_1 error [energy/mass]'
    s = f == 1 ? 0.55 : 1.8
    set yrange [(f == 1 ? 4e-4 : 1.2e-3):(f == 1 ? 0.8 : 1.2)]
    set label 1 'order 1' at 0.0045,s*0.0045*0.72 tc rgb '#606060'
    set arrow 1 from 0.002,s*0.002 to 0.01,s*0.01 nohead lc rgb '#606060' lw 2 dt (4,4)
    plot for [k=1:3] file(k) using (column('h')):(l1(word(fields, f).'_nodes')) with linespoints lt k pt 5+2*(k-1) ps 1.5 title names[k].', nodes', \
         for [k=1:3] file(k) using (column('h')):(l1(word(fields, f))) with linespoints lt k pt 4+2*(k-1) ps 1.5 lw 1 title names[k].', particles'
}
unset multiplot
