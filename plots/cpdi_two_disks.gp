# The two disks of review 6.1.2 with four kinds of particle domains, pressed together (40 cells, MUSL), and their kinetic energies. After the rebound the disks
# ring: kinetic energy and strain take turns.
load 'style.gnuplot'
set terminal pngcairo size 1500,1050 font ',18'
set output 'cpdi_two_disks.png'
array shapes[4] = ['r4', 'q4', 't3', 'polygon']
array names[4] = ['R4: boxes', 'Q4: quadrilaterals', 'T3: triangles', 'polygons']
array first[4]
do for [k = 1:4] {
    stats sprintf('data/domains-disks-%s/history.csv', shapes[k]) using (column('kinetic')) every ::0::0 nooutput
    first[k] = STATS_max
}
W = 1500.0
H = 1050.0
p = 300
set multiplot title 'Two elastic disks with particle domains (MUSL, 40 cells); above: pressed together, t = 1.9'
set size ratio -1
set view map
unset grid
unset key
set pm3d border lc rgb '#404040' lw 0.3
set palette defined (0 '#f9dc7a', 0.35 '#f1844b', 0.7 '#a8327d', 1 '#1c0f5e')
set cbrange [0:300]
set cblabel 'von Mises stress [force/area]'
set xrange [0.1:0.9]
set yrange [0.1:0.9]
set xtics 0.2
set ytics 0.2
set xlabel 'x [length]' offset 0,0.4
set tmargin at screen 1 - 110/H
set bmargin at screen 1 - (110 + p)/H
set colorbox user origin (105 + 4*(p + 15))/W, 1 - (110 + p)/H size 20/W, p/H
set label 1 'y [length]' at screen 22/W,1 - (110 + p/2.0)/H center rotate
do for [k = 1:4] {
    set lmargin at screen (100 + (k - 1)*(p + 15))/W
    set rmargin at screen (100 + (k - 1)*(p + 15) + p)/W
    set title names[k] offset 0,-0.6
    set format y (k == 1 ? '%g' : '')
    splot sprintf('data/domains-disks-%s/domains_0001.csv', shapes[k]) using (column('x')):(column('y')):(column('mises')) with polygons fc palette
    unset colorbox
    unset label 1
}
set size noratio
set grid
unset view
set lmargin at screen 100/W
set rmargin at screen 1470/W
set tmargin at screen 1 - (110 + p + 140)/H
set bmargin at screen 80/H
set xrange [0:3.8]
set xtics 0.5
set yrange [0:1.05]
set format y '%g'
set xlabel 'time t [time]'
set ylabel 'kinetic energy / initial [-]' offset 1,0
set title 'kinetic energy'
set key bottom right Left reverse samplen 4
plot for [k = 1:4] sprintf('data/domains-disks-%s/history.csv', shapes[k]) using (column('t')):(column('kinetic')/first[k]) with lines lt k title names[k]
unset multiplot
