# Review figure 17: the GIMP functions, their gradients, and how they become hats as the particles get smaller. At an end of the grid the
# functions are folded, so that no nodes outside it are needed; the other nodes' functions are the review's.
load 'style.gnuplot'
set terminal pngcairo size 1400,1400 font ',20'
set output 'basis_gimp.png'
set multiplot layout 3,1 title 'GIMP functions of four cells, particle size l_p'
set key outside right top Left reverse samplen 2
set rmargin 18
set xtics 1
set xlabel 'x / h'
set ylabel 'φ_I'
set yrange [-0.05:1.05]
set title 'l_p = h'
plot for [I=0:4] 'data/basis-gimp-1/basis_1d.csv' using (column('x')):(column('ugimp_'.I)) with lines lt I+1 title sprintf('φ_%d', I)
set title 'gradients, l_p = h'
set ylabel 'h dφ_I/dx'
set yrange [-1.1:1.1]
plot for [I=0:4] 'data/basis-gimp-1/gradients_1d.csv' using (column('x')):(column('ugimp_'.I)) with lines lt I+1 title sprintf('φ_%d', I)
set title 'the middle node as l_p decreases'
set ylabel 'φ_2'
set yrange [-0.05:1.05]
plot 'data/basis-gimp-1/basis_1d.csv' using (column('x')):(column('ugimp_2')) with lines lt 1 title 'l_p = h', \
     'data/basis-gimp-0.5/basis_1d.csv' using (column('x')):(column('ugimp_2')) with lines lt 2 title 'l_p = h/2', \
     'data/basis-gimp-0.25/basis_1d.csv' using (column('x')):(column('ugimp_2')) with lines lt 3 title 'l_p = h/4', \
     'data/basis-gimp-0.1/basis_1d.csv' using (column('x')):(column('ugimp_2')) with lines lt 5 title 'l_p = h/10'
unset multiplot
