# Review figures 53 and 54: a column of water, 4 m x 2 m, breaks down in a box of 6 m x 6 m (70 x 70 cells, 4371 particles, hat functions,
# MUSL); below with a barrier of 0.5 m, whose place and size the review does not print.
load 'style.gnuplot'
set terminal pngcairo size 2000,900 font ',20'
set output 'dam_break.png'
array runs[8] = ['dam', 'dam', 'dam', 'dam', 'dam-barrier', 'dam-barrier', 'dam-barrier', 'dam-barrier']
array frames[8] = [0, 20, 36, 85, 8, 14, 20, 34]
step(k) = k > 4 ? 0.05 : 0.02
set multiplot title 'Dam break, coloured by the speed'
unset key
unset grid
set size ratio -1
set xrange [0:6]
set yrange [0:4.5]
set xtics ('0' 0, '2' 2, '4' 4)
set ytics 2
set tics out nomirror
set cbrange [0:8]
set palette defined (0 '#deebf7', 0.25 '#9ecae1', 0.5 '#4292c6', 0.75 '#08519c', 1 '#08204d')
set cblabel 'speed [m/s]' offset -0.5,0
set cbtics 2 add ('≥ 8' 8)
unset colorbox
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set object 1 rect from 5,0 to 5.171,0.5 fc rgb '#808080' fs solid noborder behind
do for [k=1:8] {
    row = (k-1)/4
    set size 0.205,0.345
    set origin 0.05 + 0.218*((k-1)%4),0.545 - 0.425*row
    set label 1 sprintf('t = %.2f s', step(k)*frames[k]) at 0.25,4.05
    set xlabel row == 1 ? 'x [m]' : ''
    set ylabel k % 4 == 1 ? 'y [m]' : ''
    set format y k % 4 == 1 ? '%g' : ''
    set format x row == 1 ? '%g' : ''
    if (k < 5) { unset object 1 } else { set object 1 rect from 5,0 to 5.171,0.5 fc rgb '#808080' fs solid noborder behind }
    if (k == 8) { set colorbox user origin 0.925,0.15 size 0.013,0.68 }
    plot sprintf('data/%s/particles_%04d.csv', runs[k], frames[k]) using (column('x')):(column('y')):(column('speed')) \
         with points pt 5 ps 0.32 lc palette
}
unset multiplot
