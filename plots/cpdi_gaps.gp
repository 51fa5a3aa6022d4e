# Review figure 25: a compliant column hangs from its top (8 cells, one domain in a cell, g = 1000), before domains get too long. Each domain is a polygon,
# coloured by its volume ratio: between the parallelograms of CPDI-R4 gaps open, where the background shows through.
load 'style.gnuplot'
set terminal pngcairo size 1740,780 font ',18'
set output 'cpdi_gaps.png'
array name[4] = ['r4', 'q4', 't3', 'polygon']
array text[4] = ['CPDI-R4', 'CPDI-Q4', 'CPDI-T3', 'polygons']
W = 1740.0
H = 780.0
p = 330
height = 1.78
q = p * height / 1.1
t = 0.036
set multiplot title sprintf('Column in strong gravity (MUSL, 8 x 8 cells and domains, twice as many triangles), t = %g', t)
set view map
set xrange [-0.05:1.05]
set yrange [-1.72:0.06]
set xtics 0.5 offset -0.5,0.5
set ytics 0.25
set cbrange [0.9:2.1]
set palette defined (0 '#ffe9a8', 0.35 '#f6a25c', 0.7 '#c23f6d', 1 '#3b1058')
set cblabel 'volume ratio J [-]' offset 0.5,0
set pm3d border lc rgb '#202020' lw 0.6
set style fill solid border lc rgb '#202020'
unset grid
set colorbox user origin (140 + 4 * 348) / W, 1 - (115 + q) / H size 22 / W, q / H
unset key
set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb '#dff3ff' fs solid noborder
do for [i = 1:4] {
    set lmargin at screen (140 + (i - 1) * 348) / W
    set rmargin at screen (140 + (i - 1) * 348 + p) / W
    set tmargin at screen 1 - 115 / H
    set bmargin at screen 1 - (115 + q) / H
    folder = 'data/cpdi-column-'.name[i].'/'
    stats folder.'history.csv' using (column('gap')) every ::1 name 'G' nooutput
    stats folder.'history.csv' using (column('overlap')) every ::1 name 'O' nooutput
    set title sprintf("%s\ngaps %.1f %%, overlaps %.1f %%", text[i], 100 * G_max, 100 * abs(O_max)) offset 0,0.1
    set format y (i == 1 ? '%g' : '')
    set ylabel (i == 1 ? 'y [length]' : '') offset -1.8,0
    set xlabel 'x [length]' offset 0,0.4
    splot folder.'domains_0001.csv' using (column('x')):(column('y')):(column('J')) with polygons fc palette
    unset colorbox
}
unset multiplot
