# Review figure 75: the ring at its largest angle, t = T0/2, exact and by the TLMPM with Bernstein functions (h = 0.033): particles, coloured by how far they
# have moved. Particles keep their places in the files, so that the first snapshot tells where each has started.
load 'style.gnuplot'
set terminal pngcairo size 1560,830 font ',19'
set output 'vortex_ring.png'
start = 'data/vortex-ring/particles_0000.csv'
end = 'data/vortex-ring/particles_0001.csv'
R_i = 0.75; R_o = 1.25; G = 1.0  # the scene's defaults
h(R) = (1 - 4*((R - (R_i + R_o)/2)/(R_o - R_i))**2)**2
turned_x(x, y, a) = x*cos(a) - y*sin(a)
turned_y(x, y, a) = x*sin(a) + y*cos(a)
alpha(x, y) = G*h(sqrt(x**2 + y**2))
stats start using (column('x')) name 'N' nooutput
array X[N_records]
array Y[N_records]
stats start using (X[int(column(0))+1] = column('x')) nooutput
stats start using (Y[int(column(0))+1] = column('y')) nooutput
moved(i, x, y) = sqrt((x - X[i])**2 + (y - Y[i])**2)

# Particles that started on one of twelve spokes, within a hundredth of the radius.
pi_6 = pi/6
spoke(x, y) = abs(sin(atan2(y, x) - pi_6*floor(atan2(y, x)/pi_6 + 0.5))) < 0.01 ? 1 : NaN
exact_x(x, y) = turned_x(x, y, alpha(x, y))
exact_y(x, y) = turned_y(x, y, alpha(x, y))

set multiplot title 'Generalized vortex at t = T_0/2: displacement; black: what was a spoke at the start'
set size ratio -1
set tmargin at screen 0.86
set bmargin at screen 0.11
set xrange [-1.35:1.35]
set yrange [-1.35:1.35]
set xtics 0.5
set ytics 0.5
set xlabel 'x [length]'
set ylabel 'y [length]' offset 1,0
set palette defined (0 '#30123b', 0.2 '#4777ef', 0.4 '#1bd0d5', 0.55 '#62fc6b', 0.7 '#d2e935', 0.85 '#fe9b2d', 1 '#7a0403')
set cbrange [0:1]
set cblabel '|u| [length]'
unset key
unset colorbox
set lmargin at screen 0.075
set rmargin at screen 0.465
set title 'exact'
plot start using (exact_x(column('x'), column('y'))):(exact_y(column('x'), column('y'))): \
         (2*sqrt(column('x')**2 + column('y')**2)*sin(alpha(column('x'), column('y'))/2)) with points pt 7 ps 0.55 lc palette, \
     start using (exact_x(column('x'), column('y'))):(exact_y(column('x'), column('y'))*spoke(column('x'), column('y'))) \
         with points pt 7 ps 0.6 lc rgb 'black'
set lmargin at screen 0.5
set rmargin at screen 0.89
set colorbox user origin 0.905,0.11 size 0.015,0.75
set title 'TLMPM, Bernstein, h = 0.033'
unset ylabel
set format y ''
plot end using (column('x')):(column('y')):(moved(int(column(0))+1, column('x'), column('y'))) with points pt 7 ps 0.55 lc palette, \
     end using (column('x')):(column('y')*spoke(X[int(column(0))+1], Y[int(column(0))+1])) with points pt 7 ps 0.6 lc rgb 'black'
unset multiplot
