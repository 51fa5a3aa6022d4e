# Energy of the schemes: a bar in its mode 10. Drawn in a folder of figures.
load 'style.gnuplot'
set terminal pngcairo size 640,520 font ',19'
set output 'readme_energy.png'
set title 'A bar in mode 10: who keeps the energy'
set xlabel 'time t [time]'
set ylabel 'total energy [force length]' offset 0.5,0
set xrange [0:100]
set yrange [0:0.08]
set xtics 25
set ytics 0.02
set key at 98,0.047 right maxrows 4 samplen 2.5
name = 'tlmpm usf musl usl'
title = 'TLMPM USF MUSL USL'
set linetype 11 lc rgb '#e69f00' lw 9 dt solid
set linetype 12 lc rgb '#009e73' lw 4 dt solid
set linetype 13 lc rgb '#0072b2' lw 2.5 dt (4,6)
set linetype 14 lc rgb '#d55e00' lw 3.5 dt solid
plot for [i = 1:4] 'data/mode10-'.word(name, i).'/history.csv' using (column('t')):(column('total')) every 16 with lines lt 10 + i title word(title, i)
