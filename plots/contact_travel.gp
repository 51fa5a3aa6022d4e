# Travel of a block and of a disk on a slope of 30 degrees (friction 0.3, h = 0.1; last row h = 0.05) against the rigid body's, for every way to make normals and every
# test of the gap; the slab's face along the grid or inclined to it. A cross: the run became unstable.
load 'style.gnuplot'
set terminal pngcairo size 1180,960 font ',18'
set output 'contact_travel.png'
set title "Error of travel at t = 1, in % of the rigid body's, for normals and tests of the gap:\na slope of 30 degrees, friction 0.3, h = 0.1" offset -6,0.6
cases = 'sliding_block-aligned sliding_block-inclined rolling_disk-aligned rolling_disk-inclined'
ways = 'printed volume density regression'
gaps = 'velocity position extent'
unset grid
unset key
unset colorbox
set xrange [-0.5:3.5]
set yrange [12.5:-0.5]
set x2range [-0.5:3.5]
set xtics ("block,\naligned" 0, "block,\ninclined" 1, "disk,\naligned" 2, "disk,\ninclined" 3) scale 0
set ytics scale 0
set ytics ('as printed, velocity' 0, 'as printed, position' 1, 'as printed, extent' 2, 'volume, velocity' 3, 'volume, position' 4, 'volume, extent' 5, \
           'density, velocity' 6, 'density, position' 7, 'density, extent' 8, 'regression, velocity' 9, 'regression, position' 10, 'regression, extent' 11, 'the same, h = 0.05' 12)
set lmargin 23
set bmargin 3.4
set cbrange [-1:2]
set palette defined (-1 '#2f7f5f', 0 '#b8dcae', 1 '#f0b070', 2 '#a83030')
set style textbox noborder
set print $table
do for [c = 1:4] { do for [row = 0:12] {
    folder = 'data/contact-'.word(cases, c).'-'.(row < 12 ? word(ways, row/3 + 1).'-'.word(gaps, row%3 + 1) : 'fine')
    ok = system("awk -F, 'NR == 2 { print ($(NF - 2) == \"ok\") }' ".folder.'/summary.csv') eq '1'
    value = real(system("awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i } END { print $at[\"travel\"] / $at[\"travel_exact\"] - 1 }' ".folder.'/history.csv'))
    print sprintf('%d,%d,%g,%d', c - 1, row, 100 * value, ok)
} }
set print
level(v) = log10(abs(v) > 0.1 ? abs(v) : 0.1)
plot $table using 1:2:(column(4) == 1 ? level(column(3)) : 2) with image, \
     $table using 1:2:(column(4) == 1 ? sprintf('%+.1f', column(3)) : '✕ unstable') with labels font ',17' tc rgb 'black'
