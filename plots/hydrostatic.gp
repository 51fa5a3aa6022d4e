# A column of weakly compressible liquid at rest after 11 periods of its bouncing: pressure of the particles against depth.
load 'style.gnuplot'
set terminal pngcairo size 1300,720 font ',20'
set output 'hydrostatic.png'
g = 9.81; rho = 1000.0; H = 1.0
set multiplot layout 1,2 title 'A column of liquid at rest, 20 cells, t = 0.5 s'
set xlabel 'pressure [kPa]'
set ylabel 'height y [m]'
set xrange [0:10.2]
set yrange [0:1.05]
set key top right reverse Left samplen 2
set parametric
plot [t=0:1] rho*g*(H - t)/1000, t with lines lc rgb '#000000' lw 2 dt solid title 'ρ g (H - y)', \
     'data/column/particles_0001.csv' using (column('pressure')/1000):(column('y')) with points pt 6 ps 0.8 lc rgb '#d55e00' title 'hat', \
     'data/column-cubic/particles_0001.csv' using (column('pressure')/1000):(column('y')) with points pt 2 ps 0.6 lc rgb '#0072b2' title 'cubic'
unset parametric
set xlabel 'difference / ρ g H [%]'
set xrange [-2:2]
set arrow 1 from 0,0 to 0,1 nohead lw 2
unset key
plot 'data/column/particles_0001.csv' using (100*(column('pressure') - rho*g*(H - column('y')))/(rho*g*H)):(column('y')) with points pt 6 ps 0.8 lc rgb '#d55e00', \
     'data/column-cubic/particles_0001.csv' using (100*(column('pressure') - rho*g*(H - column('y')))/(rho*g*H)):(column('y')) with points pt 2 ps 0.6 lc rgb '#0072b2'
unset multiplot
