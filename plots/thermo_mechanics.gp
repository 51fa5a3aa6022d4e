# Review 5.3.2 and B.13: stress of a clamped bar heated at one end, strain of a free plate, temperature of a block in fast shear.
load 'style.gnuplot'
set terminal pngcairo size 1900,620 font ',19'
set output 'thermo_mechanics.png'
set multiplot layout 1,3 title 'Thermo-mechanics (Algorithm 9)'
set title 'clamped bar, right end hot'
set xlabel 'time t κ / L^2'
set ylabel 'mean stress / (E α ΔT)'
set key top right samplen 3
set xrange [0:0.5]
set yrange [-0.6:0]
plot 'data/thermal-bar/history.csv' using (column('t')*0.01):(column('stress')/0.01) with lines lt 2 lw 4 title 'computed', \
     'data/thermal-bar/history.csv' using (column('t')*0.01):(column('stress_exact')/0.01) with lines lt 1 dt (2,4) title 'exact'
set title 'free plate, heated evenly'
set xlabel 'time t c / L'
set ylabel 'strain / (α ΔT)'
set key top left Left reverse samplen 3
set xrange [0:100]
set yrange [0:1.1]
plot 'data/thermal-plate-rest/history.csv' using (column('t')*10):(column('eps')/1e-4) with lines lt 3 lw 4 title 'from rest', \
     'data/thermal-plate/history.csv' using (column('t')*10):(column('eps')/1e-4) with lines lt 2 lw 4 title 'started expanding', \
     'data/thermal-plate/history.csv' using (column('t')*10):(column('eps_exact')/1e-4) with lines lt 1 dt (2,4) title 'exact'
set title 'steel in adiabatic shear'
set xlabel 'shear γ'
set ylabel 'rise of temperature [K]'
set xrange [0:1]
set yrange [0:100]
plot 'data/adiabatic-500e6/history.csv' using (column('t')*1e4):(column('T_mean')) with lines lt 2 lw 4 title 'hardening 500 MPa', \
     'data/adiabatic-0/history.csv' using (column('t')*1e4):(column('T_mean')) with lines lt 3 lw 4 title 'perfectly plastic', \
     'data/adiabatic-500e6/history.csv' using (column('t')*1e4):(column('T_mean_exact')) with lines lt 1 dt (2,4) title 'exact', \
     'data/adiabatic-0/history.csv' using (column('t')*1e4):(column('T_mean_exact')) with lines lt 1 dt (2,4) notitle
unset multiplot
