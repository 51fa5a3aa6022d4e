# Review figure 64: the steel disk in the aluminium target at four times, coloured by the equivalent plastic strain (MUSL, hat functions,
# 50 x 50 grid, 6908 particles, dt = 1e-8 s); and the depth of the lowest steel against time on three grids.
load 'style.gnuplot'
set terminal pngcairo size 1500,1900 font ',20'
set output 'steel_disk.png'
set datafile missing NaN
mm = 1e3
frame(k) = sprintf('data/steel-disk-50/particles_%04d.csv', k)
is(material, value) = column('material') == material ? value : NaN

set multiplot title 'Steel disk, 1160 m/s, into aluminium'
set size ratio -1
unset key
unset grid
set xrange [0:60]
set yrange [0:55]
set xtics 10
set ytics 10
set tics out nomirror
set cbrange [0:3]
set palette defined (0 '#fff7c0', 0.15 '#fec44f', 0.4 '#e0602a', 0.7 '#9b1b4f', 1 '#2b0a3d')
set cblabel 'equivalent plastic strain ε_p [-]'
set cbtics 1 add ('≥ 3' 3)
unset colorbox
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
do for [k=1:4] {
    set size 0.38,0.285
    set origin 0.075 + 0.41*((k-1)%2),0.675 - 0.32*((k-1)/2)
    set label 1 sprintf('t = %d μs', 10*k) at 2.5,51.5
    set xlabel k > 2 ? 'x [mm]' : ''
    set ylabel k % 2 ? 'y [mm]' : ''
    set format y k % 2 ? '%g' : ''
    set format x k > 2 ? '%g' : ''
    if (k == 4) { set colorbox user origin 0.9,0.42 size 0.018,0.48 }
    plot frame(k) using (is(1, mm*column('x'))):(mm*column('y')):(column('eps_p')) with points pt 7 ps 0.5 lc palette, \
         frame(k) using (is(0, mm*column('x'))):(mm*column('y')) with points pt 7 ps 0.5 lc rgb '#607080'
}
unset colorbox
set size noratio
unset label 1
set format '%g'
set size 0.79,0.2
set origin 0.075,0.06
set xlabel 'time t [μs]'
set ylabel 'depth of the disk [mm]'
set xrange [0:40]
set yrange [0:25]
set ytics 5
set grid
set key bottom right Left reverse samplen 3
plot for [i=1:3] 'data/steel-disk-'.word('25 50 100', i).'/history.csv' using (1e6*column('t')):(mm*column('depth')) with lines \
         lt word('3 2 1', i)+0 title word('25 50 100', i).' x '.word('25 50 100', i).' cells, h = '.word('2.4 1.2 0.6', i).' mm'
unset multiplot
