# Review figures 46 and 47: grid normals of a disk (h = 0.1, 2 x 2 particles in a cell) on the nodes that it shares with a body all around it, from the
# gradient of mass (5.12) and of the cells' density (5.11); right: where the disk touches a slab, both bodies' own normals are not on one line.
load 'style.gnuplot'
set terminal pngcairo size 1800,700 font ',17'
set output 'contact_normals.png'
number(way, column) = system("awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i } $1 == \"".way."\" { printf \"%.1f\", $at[\"".column."\"] }' data/contact-normals/normals.csv")
set multiplot layout 1,3
set size ratio -1
set xlabel 'x [length]'
set ylabel 'y [length]' offset 1,0
set xrange [-0.18:1.18]
set yrange [-0.18:1.28]
set xtics 0.2
set ytics 0.2
set key top right spacing 1.1 opaque
set object 1 circle at 0.5,0.5 size 0.5 fc rgb 'black' lw 2 fs empty
a = 0.09
do for [way in 'gradient density'] {
    set title sprintf("%s\nmean error %s, largest %s degrees", way eq 'gradient' ? 'Gradient of mass (5.12)' : 'Density of the cells (5.11)', \
                      number(way, 'own_mean'), number(way, 'own_most'))
    plot 'data/contact-normals/nodes_'.way.'.csv' using (column('x')):(column('y')):(a*column('nx')):(a*column('ny')) with vectors head filled lw 2 dt solid \
         lc rgb '#d55e00' title 'grid normal', '' using (column('x')):(column('y')) with points pt 7 ps 0.8 lc rgb '#0072b2' notitle
}
set title "Touching a slab: own normals of both (5.12),\nin contact by their velocities on seven nodes"
set xrange [0.1:0.9]
set yrange [-0.3:0.558]
set arrow 1 from 0.1,0 to 0.9,0 nohead lw 2 lc rgb 'black'
plot 'data/contact-normals-slab/nodes_gradient.csv' using (column('x')):(column('y')):(a*column('nx')):(a*column('ny')) with vectors head filled lw 2 dt solid \
     lc rgb '#d55e00' title "disk's", \
     '' using (column('x')):(column('y')):(a*column('mx')):(a*column('my')) with vectors head filled lw 2 dt (6,3) lc rgb '#0072b2' title "slab's"
unset multiplot
