# The disk falls on the plate and bounces, coloured by the von Mises stress.
load 'style.gnuplot'
unset key
unset grid
set size ratio -1
set xrange [0:1.28]
set yrange [-0.16:1.84]
set xlabel 'x [m]'
set ylabel 'y [m]'
set cbrange [0:0.6]
set cblabel 'von Mises stress [MPa]'
set palette defined (0 '#deebf7', 0.25 '#9ecae1', 0.5 '#4292c6', 0.75 '#08519c', 1 '#08204d')
set terminal gif animate delay 8 loop 0 size 640,760 enhanced font 'DejaVuSans,14'
set output 'bouncing_film.gif'
do for [i=0:32] {
    set title sprintf('Disk of particles, plate of finite elements, t = %.2f s', 0.04*i)
    plot sprintf('data/bouncing-free/particles_%04d.csv', i) using (column('x')):(column('y')):(column('mises')/1e6) \
         with points pt 7 ps 0.4 lc palette
}
unset output
