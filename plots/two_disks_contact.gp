# When the disks feel each other, against when they touch (1.5858): the grid makes contact up to about a cell early, so the error falls with h. What is timed is a
# fall of the kinetic energy by 0.1 % or 1 %, which takes a while after the contact: on fine grids the larger one comes late.
load 'style.gnuplot'
set terminal pngcairo size 1000,760 font ',18'
set output 'two_disks_contact.png'
set title 'Two elastic disks: time of contact under refinement (MUSL)'
set logscale xy
set xlabel 'cell size h [length]'
set ylabel '|t_{contact} / exact - 1| [-]'
set xrange [0.005:0.065]
set yrange [1e-3:3]
set xtics ('1/160' 1.0/160, '1/80' 1.0/80, '1/40' 1.0/40, '1/20' 1.0/20)
set format y '10^{%T}'
set key left top Left reverse spacing 1.1
only(name, x) = stringcolumn('error_name') eq name ? x : NaN
set datafile missing NaN
set dummy h
dash(e) = e eq '1%' ? 2 : 1
marker(f) = f eq 'hat' ? 7 : 5
colour(f) = f eq 'hat' ? '#000000' : '#d55e00'
plot for [f in 'hat cubic'] for [e in '0.1% 1%'] 'data/disks-contact-'.f.'/summary.csv' using (column('h')):(only('contact_'.e, column('error'))) \
     with linespoints lw 2.5 ps 1.8 pt marker(f) dt dash(e) lc rgb colour(f) \
     title f.', kinetic energy fallen by '.(e eq '1%' ? '1 %' : '0.1 %'), \
     6.5*h with lines lw 1.5 dt (4,4) lc rgb '#606060' title 'order 1'
