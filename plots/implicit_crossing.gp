# A free bar flies through 1,000 cells: the energy of its vibration by what particles carry, and what is left of its mode.
load 'style.gnuplot'
set terminal pngcairo size 1500,1150 font ',20'
set output 'implicit_crossing.png'
set multiplot layout 2,1 title 'A vibrating bar flies through 1,000 cells (20 cells long, 2 particles in a cell, steps of h/c)' margins 0.09,0.72,0.08,0.89 spacing 0.16
cells(t) = t / 0.5
vibration(x) = (column('total') - 5) / 2.5e-6
at(name) = sprintf('data/crossing-%s/history.csv', name)
set key at graph 1.03,0.75 left top Left reverse samplen 3
set logscale y
set format y '10^{%L}'
set xrange [0:1000]
set yrange [1e-3:1e6]
set xlabel 'cells flown through [-]'
set ylabel 'energy of the vibration / its start [-]'
set title 'hat functions, by what particles carry (damped: β = 0.3025)'
plot at('particle') using (cells(column('t'))):(vibration(0)) with lines lt 2 lw 4 title "published, β = 1/4", \
     at('particle-0.3') using (cells(column('t'))):(vibration(0)) with lines lt 6 title 'published, β = 0.3', \
     at('projected') using (cells(column('t'))):(vibration(0)) with lines lt 4 title 'projected acceleration', \
     at('lumped') using (cells(column('t'))):(vibration(0)) with lines lt 5 title 'lumped acceleration', \
     at('damped') using (cells(column('t'))):(vibration(0)) with lines lt 3 title 'γ = 0.6', \
     at('conserving') using (cells(column('t'))):(vibration(0)) with lines lt 1 lw 4 title 'conserving midpoint'
set key at graph 1.03,0.6
unset logscale y
set format y
set yrange [0:1.3]
set ylabel 'amplitude of the mode / its start [-]'
set title 'conserving midpoint: the energy stays, a part of it leaves the mode'
plot at('conserving') using (cells(column('t'))):(column('mode')) with lines lt 2 title 'hat', \
     at('conserving-quadratic') using (cells(column('t'))):(column('mode')) with lines lt 3 title 'quadratic splines', \
     at('conserving-cubic') using (cells(column('t'))):(column('mode')) with lines lt 1 title 'cubic splines'
unset multiplot
