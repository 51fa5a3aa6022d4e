# Review 5.2: the pressure of Cook's membrane near its largest deflection, without F-bar, with that of the grid's cells and of moving ones.
load 'style.gnuplot'
set terminal pngcairo size 1900,640 font ',19'
set output 'fbar_block.png'
set multiplot layout 1,3 title 'Cook''s membrane, ν = 0.4999, 16 cells, uGIMP, MUSL: pressure of the particles [stress]'
set size ratio -1
set xrange [-1:52]
set yrange [-2:66]
set xlabel 'x [length]'
set ylabel 'y [length]'
set palette defined (-1 '#2c3e8f', -0.5 '#4fa3c7', 0 '#f2f2f2', 0.5 '#f3a35c', 1 '#b5202a')
set cbrange [-3:3]
unset key
titles = '"without F-bar" "F-bar, cells of the grid" "F-bar, moving cells"'
do for [i=1:3] {
    set title word(titles, i)
    plot 'data/cook-'.word('off grid moving', i).'/particles_0001.csv' using (column('x')):(column('y')):(column('pressure')) \
        with points pt 5 ps 1.05 lc palette notitle
}
unset multiplot
