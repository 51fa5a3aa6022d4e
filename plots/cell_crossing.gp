# Review figures 13 and 14: two bodies of one and of three particles meet and rebound (USL, six cells); and the largest jump of the force on a
# particle against the time step: hat functions keep theirs, the smooth ones lose it. With one particle per cell ugimp is the quadratic B-spline.
load 'style.gnuplot'
set terminal pngcairo size 1400,1120 font ',19'
set output 'cell_crossing.png'
shapes = 'hat quadratic ugimp cpgimp cubic'
type(s) = s eq 'hat' ? 1 : s eq 'quadratic' ? 4 : s eq 'ugimp' ? 2 : s eq 'cpgimp' ? 3 : 5
one = 'data/crossing-1/cell_crossing.csv'
three = 'data/crossing-3/cell_crossing.csv'
h = 1.0/6; v0 = 0.1; c = 1.0; K0 = 1000*h*v0**2  # of the scene's defaults

# One block for each shape: time step [h/c], largest jump of the acceleration [c v0/h].
set print $jumps
do for [s in shapes] {
    do for [cfl in '0.12 0.06 0.03 0.015 0.0075'] {
        file = 'data/crossing-cfl-'.cfl.'/summary.csv'
        stats file using (stringcolumn('shape') eq s && stringcolumn('error_name') eq 'force_jump' ? column('error') : 1/0) name 'A' nooutput
        stats file using (column('dt')) name 'T' nooutput
        print sprintf('%.17g,%.17g', T_max*c/h, A_max)
    }
    print ''
    print ''
}
unset print

set multiplot title 'Two bodies meet and rebound: what crossing cells does'
set size 1,0.09  # one legend for all
set origin 0,0.895
unset border
unset tics
set key horizontal center center samplen 3 width 2
set yrange [0:1]
plot for [s in shapes] NaN with lines lt type(s) title s
set border
set tics
unset key
set size 0.5,0.445
set xlabel 'time t [time]'
set xrange [1:4]
set origin 0,0.465
set title '1 particle per body: strain rate L of the inner particle'
set ylabel 'h L / v_0'
set yrange [-1.2:1.2]
plot for [s in shapes] one using (column('t')):(h/v0*column('strain_rate_'.s)) with lines lt type(s)
set origin 0.5,0.465
set title '1 particle per body: strain energy U'
set ylabel 'U / K_0'
set yrange [0:1.05]
plot for [s in shapes] one using (column('t')):(column('strain_'.s)/K0) with lines lt type(s)
set origin 0,0.01
set title '3 particles per body: strain energy U'
plot for [s in shapes] three using (column('t')):(column('strain_'.s)/K0) with lines lt type(s)
set origin 0.5,0.01
set title '3 particles: largest jump of acceleration a'
set xlabel 'time step c Δt / h'
set ylabel 'h Δa / (c v_0)'
set logscale xy
set xrange [0.005:0.15]
set xtics (0.01, 0.02, 0.05, 0.1)
set yrange [3e-4:3]
set format y '10^{%T}'
plot for [i=1:words(shapes)] $jumps index i-1 using 1:2 with linespoints lt type(word(shapes, i)) pt 2*i+3 ps 1.6
unset multiplot
