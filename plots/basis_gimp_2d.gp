# Review figure 18: the GIMP function of the node at (2, 2) on four by four cells, and its gradient along x.
load 'style.gnuplot'
set terminal pngcairo size 1500,620 font ',20'
set output 'basis_gimp_2d.png'
set multiplot layout 1,2 title 'GIMP function of the node at (2, 2), l_p = h/2'
set xyplane relative 0
set view 60,35,1.06,1.4
unset key
unset colorbox
set palette defined (0 '#ffffe5', 0.25 '#c7e9b4', 0.5 '#41b6c4', 0.75 '#225ea8', 1 '#081d58')
set pm3d depthorder border lc rgb '#404040' lw 0.4
set dgrid3d 41,41 qnorm 8  # the points are on this square already: heights stay as they are
set xlabel 'x / h' offset 0,-0.5
set ylabel 'y / h' offset 0,-0.5
set xtics 1 offset 0,-0.3
set ytics 1 offset 0.5,-0.3
set ztics 0.2
set title 'φ_I'
splot 'data/basis-gimp-0.5/basis_2d.csv' using (column('x')):(column('y')):(column('ugimp')) with pm3d
set ztics 0.5
set title 'h ∂φ_I/∂x'
splot 'data/basis-gimp-0.5/basis_2d.csv' using (column('x')):(column('y')):(column('ugimp_dx')) with pm3d
unset multiplot
