# Review figure 59: mode 10, USL against MUSL, with USF and TLMPM beside them (50 cells, 1 particle per cell).
set terminal pngcairo size 1200,900 font ',16'
set output 'bar_mode_10.png'
set datafile separator ','
set grid lc rgb '#dddddd'
set key outside top center horizontal
set xlabel 'time t [time]'
set multiplot layout 2,1 title 'Axial vibration of a bar, mode 10: 50 cells, 1 particle per cell'
set ylabel 'v_{cm} [length/time]'
set xrange [0:5]
plot 'data/mode10-tlmpm/history.csv' using (column('t')):(column('v_cm')) with lines lw 5 lc rgb '#f0c878' title 'TLMPM', \
     'data/mode10-usl/history.csv' using (column('t')):(column('v_cm')) with lines lw 2 lc rgb '#c03030' title 'USL', \
     'data/mode10-musl/history.csv' using (column('t')):(column('v_cm')) with lines lw 2.5 dt (8,10) lc rgb '#3060c0' title 'MUSL', \
     'data/mode10-usf/history.csv' using (column('t')):(column('v_cm')) with lines lw 2.5 dt (2,8) lc rgb '#40a040' title 'USF', \
     'data/mode10-musl/history.csv' using (column('t')):(column('v_cm_exact')) with lines lw 1.5 dt 2 lc rgb 'black' title 'exact'
set ylabel 'total energy [force length]'
set xrange [0:100]
set yrange [0:0.08]
plot 'data/mode10-tlmpm/history.csv' using (column('t')):(column('total')) with lines lw 5 lc rgb '#f0c878' title 'TLMPM', \
     'data/mode10-usl/history.csv' using (column('t')):(column('total')) with lines lw 2 lc rgb '#c03030' title 'USL', \
     'data/mode10-musl/history.csv' using (column('t')):(column('total')) with lines lw 2.5 dt (8,10) lc rgb '#3060c0' title 'MUSL', \
     'data/mode10-usf/history.csv' using (column('t')):(column('total')) with lines lw 2.5 dt (2,8) lc rgb '#40a040' title 'USF', \
     0.0625 with lines lw 1.5 dt 2 lc rgb 'black' title 'exact'
unset multiplot
