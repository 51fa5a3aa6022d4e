# Review figure 61: two disks before, at and after their contact (MUSL, hat, 40 cells, 2 x 2 particles per cell). Each particle is a square of its area.
load 'style.gnuplot'
set terminal pngcairo size 1700,900 font ',18'
set output 'two_disks_snapshots.png'
folder = 'data/disks-snapshots/'
array frame[4] = [0, 8, 10, 18]
stats folder.'frames.csv' using (column('t')) nooutput
t(i) = 3.5 * frame[i] / (STATS_records - 1)
box = '(0.515 * sqrt(column("V")))'
W = 1700.0
H = 900.0
p = 330
set multiplot title 'Two elastic disks (MUSL, hat functions, 40 cells): von Mises stress and speed'
set xrange [-0.03:1.03]
set yrange [-0.03:1.03]
set xtics 0.2
set ytics 0.2
unset key
do for [row = 0:1] {
    name = row == 0 ? 'mises' : 'speed'
    if (row == 0) { set palette defined (0 '#f9dc7a', 0.35 '#f1844b', 0.7 '#a8327d', 1 '#1c0f5e') }
    if (row == 1) { set palette defined (0 '#d8eedd', 0.5 '#7bccc4', 1 '#084081') }
    set cblabel (row == 0 ? 'von Mises stress [force/area]' : 'speed |v| [length/time]') offset 0.5,0
    if (row == 0) { set cbrange [0:300] }
    if (row == 1) { set cbrange [0:0.2] }
    set colorbox user origin (115 + 4 * 355) / W, 1 - (85 + 400 * row + p) / H size 22 / W, p / H
    set tmargin at screen 1 - (85 + 400 * row) / H
    set bmargin at screen 1 - (85 + 400 * row + p) / H
    set format x (row == 0 ? '' : '%g')
    set xlabel (row == 0 ? '' : 'x [length]') offset 0,0.4
    do for [i = 1:4] {
        set lmargin at screen (110 + (i - 1) * 355) / W
        set rmargin at screen (110 + (i - 1) * 355 + p) / W
        set title (row == 0 ? sprintf('t = %.3g', t(i)) : '') offset 0,-0.6
        set format y (i == 1 ? '%g' : '')
        set ylabel (i == 1 ? 'y [length]' : '') offset 0.3,0
        plot folder.sprintf('particles_%04d.csv', frame[i]) using (column('x')):(column('y')):@box:@box:(column(name)) \
             with boxxyerror fs solid noborder lc palette
        unset colorbox
    }
}
unset multiplot
