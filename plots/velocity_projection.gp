# Review figure 55: the velocities that the nodes get from particles of the field v = x, and which transfers mend their errors (flip: lumped mass).
load 'style.gnuplot'
set terminal pngcairo size 1400,1080 font ',19'
set output 'velocity_projection.png'
shapes = 'hat quadratic cubic bernstein'
type(s) = s eq 'hat' ? 1 : s eq 'quadratic' ? 4 : s eq 'cubic' ? 5 : 2

# One block for each shape: terms of the series, largest error of the nodes.
set print $series
do for [s in shapes] {
    do for [k in '1 2 4 8 16 32 64'] {
        file = 'data/projection-fmpm-'.k.'/projection.csv'
        stats file using (stringcolumn('shape') eq s ? column('node_ends') : 1/0) name 'A' nooutput
        stats file using (stringcolumn('shape') eq s ? column('node_middle') : 1/0) name 'B' nooutput
        print sprintf('%s,%.17g', k, A_max > B_max ? A_max : B_max)
    }
    print ''
    print ''
}
unset print

set multiplot layout 2,2 title 'A linear velocity field, from the particles to the nodes'
set key top left Left reverse samplen 2.5
set xlabel 'x [length]'
set title '3 cells, 1 particle per cell, hat'
set ylabel 'v [length/time]'
set xrange [-0.3:6.3]
set yrange [-0.5:10]
review = 'data/projection-review/'
plot x with lines lt 1 title 'field v = x', \
     review.'particles_hat.csv' using (column('x')):(column('v_exact')) with points pt 7 ps 1.8 lc rgb '#999999' title 'particles', \
     review.'nodes_hat.csv' using (column('x')):(column('v_flip')) with linespoints lt 2 pt 4 ps 2.2 title 'nodes, lumped mass', \
     review.'nodes_hat.csv' using (column('x')):(column('v_apic')) with points pt 6 ps 2.6 lw 2 lc rgb '#0072b2' title 'nodes, APIC and MLS'
set key top right noreverse Right
set ylabel '(v_I − x_I) / h'
set yrange [-0.5:0.5]
do for [s in 'hat cubic'] {
    set title '12 cells, 3 shifted particles per cell, '.s
    plot 'data/projection-shifted/nodes_'.s.'.csv' using (column('x')):(column('error_flip')) with linespoints lt 2 pt 4 ps 1.7 title 'lumped mass', \
         '' using (column('x')):(column('error_fmpm')) with linespoints lt 3 pt 8 ps 1.7 title 'FMPM(2)', \
         '' using (column('x')):(column('error_consistent')) with linespoints lt 1 pt 6 ps 1.7 title 'consistent mass, APIC, MLS'
}
set title 'FMPM(k): largest error of the nodes'
set key bottom left Left reverse
set xlabel 'terms k'
set ylabel 'max |v_I − x_I| / h'
set logscale xy
set xrange [0.9:72]
set xtics (1, 2, 4, 8, 16, 32, 64)
set yrange [1e-9:1]
set format y '10^{%T}'
plot for [i=1:words(shapes)] $series index i-1 using 1:2 with linespoints lt type(word(shapes, i)) pt 2*i+3 ps 1.6 title word(shapes, i)
unset multiplot
