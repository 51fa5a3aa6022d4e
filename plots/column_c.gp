# Report figure 9 (energy against time), and the question that it leaves open: which transfer keeps the energy, and at what cost.
load 'style.gnuplot'
set terminal pngcairo size 1500,1250 font ',20'
set output 'column_c.png'
set multiplot title 'Bar with an initial kinetic energy: 32 cells, 3 particles per cell, hat functions'
run(name) = 'data/column-c-uniform-'.name.'/history.csv'
E0 = 5e-5
set size 1,0.46
set origin 0,0.5
set key outside right center Left reverse samplen 3
set xlabel 'time t [s]'
set ylabel 'energy / energy at the start'
set xrange [0:0.2]
set yrange [0:1.05]
plot run('flip') using (column('t')):(column('total') / E0) with lines lt 1 title 'FLIP (α = 1)', \
     run('consistent') using (column('t')):(column('total') / E0) with lines lt 3 title 'consistent mass', \
     run('fmpm8') using (column('t')):(column('total') / E0) with lines lt 4 title 'FMPM(8)', \
     run('apic') using (column('t')):(column('total') / E0) with lines lt 5 title 'APIC', \
     run('usl') using (column('t')):(column('total') / E0) with lines lt 6 title 'USL, α = 1', \
     'data/column-c-report/history.csv' using (column('t')):(column('total') / E0) with lines lt 2 title "order 2,\nα = 0.5 (report)", \
     run('mix') using (column('t')):(column('total') / E0) with lines lt 2 lw 4 dt solid title 'α = 0.5', \
     run('pic') using (column('t')):(column('total') / E0) with lines lt 3 lw 4 dt solid title 'PIC (α = 0)'
set origin 0,0
set size 1,0.5
set title 'energy lost by t = 0.2 s and run time: a jump of velocity at the fixed end (filled), and a smooth start (open)'
set xlabel 'run time [ns per particle step]'
set ylabel 'energy lost / energy at the start'
set logscale xy
set xrange [*:*]
set yrange [1e-3:1.5]
set format y '10^{%T}'
unset key
names = 'mix pic flip usl apic consistent xpic2 xpic5 fmpm2 fmpm4 fmpm8 fmpm16 fem'
label(name) = name eq 'mix' ? 'α = 0.5' : name eq 'pic' ? 'PIC' : name eq 'flip' ? 'FLIP' : name eq 'usl' ? 'USL' : name eq 'apic' ? 'APIC' : name eq 'consistent' ? 'consistent' : \
    name eq 'fem' ? 'finite elements' : name[1:4] eq 'xpic' ? 'XPIC('.name[5:].')' : 'FMPM('.name[5:].')'
summary(start, name) = 'data/column-c-'.start.'-'.name.'/summary.csv'
plot for [name in names] summary('uniform', name) using (column('ns_per_particle_step')):(column('error')) with points pt 7 ps 2 lc rgb '#d55e00', \
     for [name in names] summary('smooth', name) using (column('ns_per_particle_step')):(column('error')) with points pt 6 ps 2 lw 2 lc rgb '#0072b2', \
     for [name in names] summary('uniform', name) using (column('ns_per_particle_step')):(column('error')):(label(name)) with labels left offset 1,0.4
unset multiplot
