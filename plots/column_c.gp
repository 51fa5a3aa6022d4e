# Report figure 9 (energy against time), and the question that it leaves open: which transfer keeps the energy, and at what cost.
load 'style.gnuplot'
set terminal pngcairo size 1500,1500 font ',20'
set output 'column_c.png'
set multiplot title 'Which transfer keeps the energy? Bar with 32 cells, 3 particles per cell, hat functions'
run(name) = 'data/column-c-uniform-'.name.'/history.csv'
report = 'data/column-c-report/history.csv'
E0 = 5e-5
set lmargin at screen 0.11
set rmargin at screen 0.74
set size 1,0.31
set key outside right center Left reverse samplen 3
set xlabel 'time t [s]'
set ylabel 'energy / start'
set xrange [0:0.2]
set xtics 0.05
set origin 0,0.655
set yrange [0:1.1]
plot run('flip') using (column('t')):(column('total') / E0) with lines lt 1 title 'FLIP (α = 1)', \
     report using (column('t')):(column('total') / E0) with lines lt 3 title 'order 2, α = 0.5', \
     run('mix') using (column('t')):(column('total') / E0) with lines lt 2 title 'α = 0.5', \
     run('pic') using (column('t')):(column('total') / E0) with lines lt 5 title 'PIC (α = 0)'
set origin 0,0.36
set yrange [0.9:1.02]
set format y '%.2f'
plot run('flip') using (column('t')):(column('total') / E0) with lines lt 1 lw 2 title 'FLIP (α = 1)', \
     run('fmpm16') using (column('t')):(column('total') / E0) with lines lt 4 lw 2 title 'FMPM(16)', \
     run('apic') using (column('t')):(column('total') / E0) with lines lt 5 lw 2 title 'APIC', \
     run('usl') using (column('t')):(column('total') / E0) with lines lt 6 lw 2 title 'FLIP, USL', \
     report using (column('t')):(column('total') / E0) with lines lt 3 lw 2 title 'order 2, α = 0.5', \
     run('fmpm2') using (column('t')):(column('total') / E0) with lines lt 2 lw 2 title 'FMPM(2)'
set origin 0,0
set size 1,0.36
set title 'at t = 0.2 s, started by a jump of velocity at the fixed end (filled) or smoothly (open)'
set xlabel 'run time [ns per particle step]'
set ylabel '|energy / start - 1|'
set logscale y
set xrange [20:*]
set xtics auto
set yrange [5e-4:3]
set format y '10^{%T}'
at(start, name) = 'data/column-c-'.start.'-'.name.'/summary.csv'
x(n) = column('ns_per_particle_step')
y(n) = column('error')
array name = ['pic', 'mix', 'flip', 'usl', 'apic', 'xpic2', 'xpic5', 'fmpm2', 'fmpm4', 'fmpm8', 'fmpm16', 'consistent', 'fem']
array text = ['α = 0', 'α = 0.5', 'α = 1', '', '', '2', '5', '2', '4', '8', '16', '', '']
array kind = ['PIC to FLIP', '', '', 'FLIP, USL', 'APIC', 'XPIC(k)', '', 'FMPM(k)', '', '', '', 'consistent mass', 'finite elements']
array mark = [5, 5, 5, 15, 11, 9, 9, 7, 7, 7, 7, 13, 3]
array tint = [1, 1, 1, 6, 5, 4, 4, 2, 2, 2, 2, 3, 1]
array side = [0.8, -0.9, 0.8, 0, 0, -0.8, -0.8, 0.8, 0.8, 0.8, 0.8, 0, 0]
set label 1 'below: kinetic and strain energy are half a step apart' at graph 0.99,first 6.2e-3 right font ',17'
set arrow 1 from graph 0,first 5e-3 to graph 1,first 5e-3 nohead lc rgb '#888888' dt (2,4) lw 2
plot for [i=1:13] at('uniform', name[i]) using (x(0)):(y(0)) with points pt mark[i] ps 2 lw 2 lt tint[i] title kind[i], \
     for [i=1:13] at('smooth', name[i]) using (x(0)):(y(0)) with points pt (mark[i] == 3 ? 1 : mark[i] - 1) ps 2 lw 2 lt tint[i] notitle, \
     for [i=1:13] at('uniform', name[i]) using (x(0)):(y(0)):(text[i]) with labels offset 0,side[i] font ',16' notitle
unset multiplot
