# Review figures 31 and 32: a small particle falls on a wide one, 7 x 7 cells (CPDI-R4, MUSL). A domain of 3.4 cells has a hole between its corners; one of
# 2.8 has none, nor have the two halves into which 3.4 is split.
load 'style.gnuplot'
set terminal pngcairo size 1400,1130 font ',18'
set output 'cpdi_hole.png'
array name[3] = ['wide', 'narrow', 'split']
array text[3] = ['3.4 cells wide', '2.8 cells wide', '3.4 cells, split']
W = 1400.0
H = 1130.0
p = 290
set multiplot title 'A small particle falls on a wide one at rest: domains of CPDI-R4'
set view map
set xrange [0:7]
set yrange [0:7]
set xtics 0,1,6
set ytics 0,1,6
set grid lt 1 lc rgb '#bbbbbb' lw 0.7 front
set palette defined (0 '#d55e00', 1 '#0072b2')
set cbrange [0:1]
set pm3d border lc rgb '#202020' lw 1.2
set style fill solid border lc rgb '#202020'
unset colorbox
unset key
do for [row = 1:3] {
    folder = 'data/cpdi-hole-'.name[row].'/'
    do for [i = 1:4] {
        frame = 2 * (i - 1)
        set lmargin at screen (170 + (i - 1) * 303) / W
        set rmargin at screen (170 + (i - 1) * 303 + p) / W
        set tmargin at screen 1 - (105 + (row - 1) * 318) / H
        set bmargin at screen 1 - (105 + (row - 1) * 318 + p) / H
        set title (row == 1 ? sprintf('t = %.3g', 4.0 * frame / 6) : '') offset 0,-0.6
        set format y (i == 1 ? '%g' : '')
        set format x (row == 3 ? '%g' : '')
        set ylabel (i == 1 ? text[row]."\ny [length]" : '') offset -3.4,0
        set xlabel (row == 3 ? 'x [length]' : '') offset 0,0.4
        splot folder.sprintf('domains_%04d.csv', frame) using (column('x')):(column('y')):(column('particle') > 0) with polygons fc palette
    }
}
unset multiplot
