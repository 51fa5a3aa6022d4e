# Sod's shock tube in motion: nodes of cpGIMP functions, 300 cells, beside the exact solution.
load 'style.gnuplot'
set terminal gif animate delay 8 loop 0 size 1000,760 enhanced font 'DejaVuSans,14'
set output 'shock_tube_film.gif'
fields = 'rho v p e'
array labels[4] = ['density [mass/length]', 'velocity [length/time]', 'pressure [force]', 'energy [energy/mass]']
array low[4] = [0, -0.1, 0, 1.5]
array high[4] = [1.1, 1.1, 1.1, 3.3]
file(i) = sprintf('data/sod-cpgimp-film/nodes_%04d.csv', i)
unset key
set xrange [0:1]
set xlabel 'x [length]'
do for [i=0:40] {
    set multiplot layout 2,2 title sprintf("Sod's shock tube, t = %.3f: cpGIMP (points) and exact", 0.143*i/40.0)
    do for [f=1:4] {
        set ylabel labels[f]
        set yrange [low[f]:high[f]]
        plot file(i) using (column('x')):(column(word(fields, f))) with points pt 7 ps 0.4 lc rgb '#d55e00', \
             file(i) using (column('x')):(column(word(fields, f).'_exact')) with lines lw 1.5 lc rgb '#000000' dt solid
    }
    unset multiplot
}
unset output
