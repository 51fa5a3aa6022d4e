# A thick cylinder under inner pressure by CPDI (review 3.6, pressure on edges 4.2.3): stresses over the radius on 20 cells against Lame, and
# how errors fall. Displacements follow u ~ h^2; a domain's stress is a mean that is compared with the value at its centroid.
load 'style.gnuplot'
set terminal pngcairo size 1600,800 font ',18'
set output 'cpdi_cylinder.png'
array shapes[3] = ['t3', 'polygon', 'q4']
array names[3] = ['triangles', 'polygons', 'quadrilaterals']
array colours[3] = ['#0072b2', '#009e73', '#d55e00']
array marks[3] = [2, 8, 6]
a = 0.5; b = 1; p = 1e-3  # the program's defaults
r(x, y) = sqrt(x**2 + y**2)
radial(x, y, sxx, syy, sxy) = (sxx*x**2 + syy*y**2 + 2*sxy*x*y)/(x**2 + y**2)/p
hoop(x, y, sxx, syy, sxy) = (sxx*y**2 + syy*x**2 - 2*sxy*x*y)/(x**2 + y**2)/p
lame(x, sign) = a**2/(b**2 - a**2)*(1 + sign*(b/x)**2)
set multiplot layout 1,2 title 'Thick cylinder under inner pressure p, r_i = 0.5, r_o = 1 (CPDI)'
set lmargin 9
set rmargin 2
set tmargin 4
set bmargin 7
set title 'stress in each domain, 20 cells across the outer radius'
set xlabel 'radius r [length]'
set ylabel 'stress / p [-]' offset 1,0
set xrange [0.48:1.02]
set yrange [-1.1:1.9]
set key at screen 0.5,0.095 center top horizontal Left reverse samplen 2 maxcols 4 width 1
set label 1 'hoop' at 0.8,1.1
set label 2 'radial' at 0.8,-0.4
plot for [k=1:3] sprintf('data/cylinder-%s/cells-20/particles_0001.csv', shapes[k]) using (r(column('x'), column('y'))): \
         (hoop(column('x'), column('y'), column('sxx'), column('syy'), column('sxy'))) with points pt marks[k] ps 0.8 lc rgb colours[k] title names[k], \
     for [k=1:3] sprintf('data/cylinder-%s/cells-20/particles_0001.csv', shapes[k]) using (r(column('x'), column('y'))): \
         (radial(column('x'), column('y'), column('sxx'), column('syy'), column('sxy'))) with points pt marks[k] ps 0.8 lc rgb colours[k] notitle, \
     [0.5:1] lame(x, 1) with lines lt 1 title 'Lamé', [0.5:1] lame(x, -1) with lines lt 1 notitle
unset label
set title 'relative L_2 error over the domains'
set xlabel 'cell size h [length]'
set ylabel 'error [-]' offset 1,0
set logscale xy
set xrange [0.011:0.056]
set xtics ('1/80' 0.0125, '1/40' 0.025, '1/20' 0.05)
set yrange [1e-5:0.2]
set format y '10^{%T}'
unset key
set label 1 'hoop stress' at 0.0128,0.0029
set label 2 'displacement' at 0.0128,1.6e-5
set label 3 'order 1' at 0.029,0.1
set label 4 'order 2' at 0.029,3e-3
of(name) = strcol('error_name') eq name ? column('error') : NaN
set datafile missing NaN
plot for [k=1:3] sprintf('data/cylinder-%s/summary.csv', shapes[k]) using (column('h')):(of('hoop')) with linespoints dt 2 pt marks[k] ps 1.4 lw 2 \
         lc rgb colours[k], \
     for [k=1:3] sprintf('data/cylinder-%s/summary.csv', shapes[k]) using (column('h')):(of('displacement')) with linespoints dt 1 pt marks[k] ps 1.4 lw 2 \
         lc rgb colours[k], \
     2.2*x with lines lw 1.5 dt 3 lc rgb 'black', 1.6*x**2 with lines lw 1.5 dt 3 lc rgb 'black'
unset multiplot
