# The dam break in motion, coloured by the speed.
load 'style.gnuplot'
unset key
unset grid
set size ratio -1
set xrange [0:6]
set yrange [0:6]
set xlabel 'x [m]'
set ylabel 'y [m]'
set cbrange [0:8]
set cblabel 'speed [m/s]'
set palette defined (0 '#deebf7', 0.25 '#9ecae1', 0.5 '#4292c6', 0.75 '#08519c', 1 '#08204d')
if (!exists('film')) film = 1
data = word('dam dam-barrier', film)
last = film == 1 ? 84 : 34
every_ = film == 1 ? 2 : 1
dt = film == 1 ? 0.02 : 0.05
set terminal gif animate delay 8 loop 0 size 760,640 enhanced font 'DejaVuSans,14'
set output word('dam_break_film.gif dam_break_barrier_film.gif', film)
if (film == 2) { set object 1 rect from 5,0 to 5.171,0.5 fc rgb '#808080' fs solid noborder behind }
do for [i=0:last:every_] {
    set title sprintf('Dam break: 4371 particles, t = %.2f s', dt*i)
    plot sprintf('data/%s/particles_%04d.csv', data, i) using (column('x')):(column('y')):(column('speed')) \
         with points pt 5 ps 0.35 lc palette
}
unset output
