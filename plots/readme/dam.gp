# Water breaking down. Drawn in a folder of figures.
load 'style.gnuplot'
set terminal pngcairo size 640,520 font ',19'
set output 'readme_dam.png'
set multiplot title 'Dam break, coloured by the speed'
unset key
unset grid
set size ratio -1
set xrange [0:6]
set yrange [0:4.5]
set xtics out nomirror
set ytics 2 out nomirror
set cbrange [0:8]
set palette defined (0 '#deebf7', 0.25 '#9ecae1', 0.5 '#4292c6', 0.75 '#08519c', 1 '#08204d')
set cblabel 'speed [m/s]'
set cbtics 4
array frame[4] = [0, 20, 36, 85]
do for [k = 1:4] {
    row = (k - 1) / 2
    set lmargin at screen 0.12 + 0.375 * ((k - 1) % 2)
    set rmargin at screen 0.47 + 0.375 * ((k - 1) % 2)
    set tmargin at screen 0.91 - 0.40 * row
    set bmargin at screen 0.57 - 0.40 * row
    set label 1 sprintf('t = %.2f s', 0.02 * frame[k]) at 5.8,3.9 right font ',16'
    set xlabel row == 1 ? 'x [m]' : '' offset 0,0.5
    set ylabel k % 2 == 1 ? 'y [m]' : '' offset 0.5,0
    if (row == 1) { set xtics ('0' 0, '2' 2, '4' 4) } else { set xtics ('' 0, '' 2, '' 4) }
    set format y k % 2 == 1 ? '%g' : ''
    if (k == 4) { set colorbox user origin 0.865,0.15 size 0.025,0.72 } else { unset colorbox }
    plot sprintf('data/dam/particles_%04d.csv', frame[k]) using (column('x')):(column('y')):(column('speed')) with points pt 5 ps 0.35 lc palette
}
unset multiplot
