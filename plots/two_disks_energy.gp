# Review figure 62: energies of the two disks (20 cells, dt = 0.001). The dip of the total at full compression belongs to the energy measure of the rate form,
# 1/2 sigma:eps; what is missing at the end is what the scheme has lost.
# USL without cut-off jumps where the disks part: a node with hardly any mass throws a particle's stress.
load 'style.gnuplot'
set terminal pngcairo size 1500,700 font ',18'
set output 'two_disks_energy.png'
set multiplot layout 1,2 title 'Two elastic disks: energies'
set xlabel 'time t [time]'
set xrange [0:3.5]
set key at screen 0.29,0.1 center top horizontal Left reverse width 1
set lmargin 9
set rmargin 2
set bmargin 7
set tmargin 4
set title 'MUSL, hat'
set ylabel 'energy [force length]'
set yrange [0:3]
file = 'data/disks-musl-hat/history.csv'
plot file using (column('t')):(column('kinetic')) with lines lt 2 title 'kinetic', \
     file using (column('t')):(column('strain')) with lines lt 3 title 'strain', \
     file using (column('t')):(column('total')) with lines lt 1 title 'total'
set title 'total energy of six variants, relative to the start'
set ylabel 'total energy / initial [-]'
set yrange [0.9:1.02]
set key at screen 0.74,0.13 center top horizontal Left reverse maxcols 3 width 1
total(s, f) = sprintf('data/disks-%s-%s/history.csv', s, f)
array schemes[3] = ['musl', 'usf', 'usl']
array names[3] = ['MUSL', 'USF', 'USL']
array colours[3] = ['#000000', '#0072b2', '#d55e00']
start = 2.6
dash(f) = f eq 'hat' ? 1 : 2
plot for [f in 'hat cubic'] for [k=1:3] total(schemes[k], f) using (column('t')):(column('total')/start) with lines lw 2.5 \
     lc rgb colours[k] dt dash(f) title names[k].', '.f
unset multiplot
