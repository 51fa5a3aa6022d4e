# Why the iMPM needs more than one quadrature point per cell in the plane: a vibrating cantilever, 32 x 4 cells. Motion that leaves the stress in the middle of a cell
# unchanged (hourglass) meets no force there.
load 'style.gnuplot'
set terminal pngcairo size 1300,900 font ',18'
set output 'impm_hourglass.png'
set multiplot title 'Improved MPM, vibrating cantilever: quadrature in the middle of cells and at 2 x 2 Gauss points'
set size 1,0.46
set origin 0,0.47
set xlabel 'time t [time]' offset 0,0.5
set ylabel 'displacement of the tip [length]'
set key bottom left Left reverse samplen 3
set xrange [0:12.2]
plot 'data/beam-gauss/history.csv' using (column('t')):(column('tip_exact')) with lines lt 1 lw 1.5 title 'Timoshenko beam', \
     'data/beam-gauss/history.csv' using (column('t')):(column('tip')) with lines lt 3 dt solid lw 3 title '2 x 2 points', \
     'data/beam-centre/history.csv' using (column('t')):(column('tip')) with lines lt 2 title 'one point'
set size 0.55,0.46
set xlabel 'x [length]'
set ylabel 'y [length]'
set xrange [0:8.4]
set yrange [-0.6:1.5]
set cbrange [-3:3]
set cblabel 'σ_{xx} [stress]'
set palette defined (-1 '#0072b2', 0 '#eeeeee', 1 '#d55e00')
unset key
do for [q in 'centre gauss'] {
    set origin (q eq 'centre' ? 0 : 0.47),0
    set title (q eq 'centre' ? 'one point, t = T' : '2 x 2 points, t = T')
    if (q eq 'centre') { unset colorbox; set size 0.47,0.46 } else { set colorbox; set size 0.53,0.46 }
    plot 'data/beam-'.q.'/particles_0001.csv' using (column('x')):(column('y')):(column('sxx')) with points pt 7 ps 0.9 palette
}
unset multiplot
