# Report figure 7: stress and displacement of the quasi-static column against time, stress against strain (TLMPM, hat, 10 cells, alpha = 0.5).
load 'style.gnuplot'
set terminal pngcairo size 1500,1150 font ',20'
set output 'column_a.png'
set multiplot title 'Column under slowly growing compression'
mpm = 'data/column-a/history.csv'
fem = 'data/column-a-fem/history.csv'
set key bottom left Left reverse samplen 3
set xrange [0:1.2]
set xlabel 'time t [s]'
set size 0.5,0.47
set origin 0,0.48
set title 'stress at X = L/10'
set ylabel 'stress [kPa]'
set yrange [-28:0]
plot mpm using (column('t')):(column('sigma') / 1e3) with lines lt 4 lw 6 title 'Cauchy σ', \
     mpm using (column('t')):(column('S') / 1e3) with lines lt 6 lw 6 dt solid title '2nd Piola-Kirchhoff S', \
     fem every 300 using (column('t')):(column('sigma') / 1e3) with points pt 6 ps 1.4 lw 2 lc rgb '#0072b2' title 'finite elements', \
     fem every 300 using (column('t')):(column('S') / 1e3) with points pt 6 ps 1.4 lw 2 lc rgb '#0072b2' notitle, \
     mpm using (column('t')):(column('sigma_exact') / 1e3) with lines lt 1 dt (2,4) title 'static', \
     mpm using (column('t')):(column('S_exact') / 1e3) with lines lt 1 dt (2,4) notitle
set origin 0.5,0.48
set title 'displacement of the free end'
set ylabel 'u(L) [mm]'
set yrange [-66:0]
set key top right Left reverse
plot mpm using (column('t')):(1e3 * column('u_end')) with lines lt 4 lw 6 title 'moved with the grid', \
     'data/column-a-particle/history.csv' using (column('t')):(1e3 * column('u_end')) with lines lt 2 title 'x += dt v_p (line 29)', \
     fem every 300 using (column('t')):(1e3 * column('u_end')) with points pt 6 ps 1.4 lw 2 lc rgb '#0072b2' title 'finite elements', \
     mpm using (column('t')):(1e3 * column('u_end_exact')) with lines lt 1 dt (2,4) title 'static'
set size 1,0.48
set origin 0,0
set title 'stress against strain at X = L/10'
set xlabel 'strain [-]'
set ylabel 'stress [kPa]'
set xrange [-2.5:0]
set yrange [-25:0]
set key outside right center samplen 3
stress(name) = column(name) / 1e3
plot mpm using (column('green')):(stress('sigma')) with lines lt 1 title 'σ, Green', \
     mpm using (column('hencky')):(stress('sigma')) with lines lt 5 title 'σ, Hencky', \
     mpm using (column('almansi')):(stress('sigma')) with lines lt 3 title 'σ, Almansi', \
     mpm using (column('green')):(stress('S')) with lines lt 4 title 'S, Green', \
     mpm using (column('hencky')):(stress('S')) with lines lt 2 title 'S, Hencky', \
     mpm using (column('almansi')):(stress('S')) with lines lt 6 title 'S, Almansi', \
     for [strain in 'green hencky almansi'] for [s in 'sigma S'] fem every 300 using (column(strain)):(stress(s)) with points pt 6 ps 1.4 lw 2 \
         lc rgb '#0072b2' title (strain.s eq 'greensigma' ? 'finite elements' : '')
unset multiplot
