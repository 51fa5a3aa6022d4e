# Review figures 66 to 68: Sod's shock tube at t = 0.143, 300 cells, 3 particles a cell, MUSL: particles without and with artificial
# viscosity, nodes with it (hat functions), and nodes with cpGIMP functions.
load 'style.gnuplot'
set terminal pngcairo size 2000,1800 font ',20'
set output 'shock_tube.png'
columns_ = 4
runs = 'hat-plain hat hat cpgimp'
files = 'particles_0001 particles_0001 nodes_0001 nodes_0001'
array heads[4] = ['hat, particles, no viscosity', 'hat, particles', 'hat, nodes', 'cpGIMP, nodes']
fields = 'rho v p e'
array labels[4] = ['density [mass/length]', 'velocity [length/time]', 'pressure [force]', 'energy [energy/mass]']
array low[4] = [0, -0.2, 0, 1.5]
array high[4] = [1.2, 1.5, 1.2, 3.6]
file(k) = 'data/sod-'.word(runs, k).'/'.word(files, k).'.csv'
set multiplot title "Sod's shock tube, t = 0.143: 300 cells, black the exact solution"
unset key
set xrange [0:1]
set xtics 0.25
do for [row=1:4] {
    do for [k=1:columns_] {
        set lmargin at screen 0.065 + 0.236*(k-1)
        set rmargin at screen 0.065 + 0.236*(k-1) + 0.216
        set tmargin at screen 0.925 - 0.22*(row-1)
        set bmargin at screen 0.925 - 0.22*(row-1) - 0.2
        set title row == 1 ? heads[k] : '' offset 0,-0.6
        set ylabel k == 1 ? labels[row] : '' offset 0.5,0
        set format y k == 1 ? '%g' : ''
        set format x row == 4 ? '%g' : ''
        set xlabel row == 4 ? 'x [length]' : ''
        set yrange [low[row]:high[row]]
        plot file(k) using (column('x')):(column(word(fields, row))) with points pt 7 ps 0.45 lc rgb '#d55e00', \
             file(k) using (column('x')):(column(word(fields, row).'_exact')) with lines lw 1.5 lc rgb '#000000' dt solid
    }
}
unset multiplot
