# Review figure 58: mode 1, FLIP against PIC (USL, 16 cells, 2 particles per cell).
set terminal pngcairo size 1200,900 font ',16'
set output 'bar_mode_1.png'
set datafile separator ','
set grid lc rgb '#dddddd'
set key outside top center horizontal
set xlabel 'time t [time]'
set xrange [0:100]
set multiplot layout 2,1 title 'Axial vibration of a bar, mode 1: USL, 16 cells, 2 particles per cell'
set ylabel 'v_{cm} [length/time]'
plot 'data/mode1-flip/history.csv' using (column('t')):(column('v_cm')) with lines lw 2 lc rgb '#c03030' title 'FLIP ({/Symbol a} = 1)', \
     'data/mode1-pic/history.csv' using (column('t')):(column('v_cm')) with lines lw 2.5 dt (8,3) lc rgb '#3060c0' title 'PIC ({/Symbol a} = 0)', \
     'data/mode1-flip/history.csv' using (column('t')):(column('v_cm_exact')) with lines lw 1.5 dt 2 lc rgb 'black' title 'exact'
set ylabel 'total energy [force length]'
set yrange [0:*]
plot 'data/mode1-flip/history.csv' using (column('t')):(column('total')) with lines lw 2 lc rgb '#c03030' title 'FLIP', \
     'data/mode1-pic/history.csv' using (column('t')):(column('total')) with lines lw 2.5 dt (8,3) lc rgb '#3060c0' title 'PIC', \
     0.0625 with lines lw 1.5 dt 2 lc rgb 'black' title 'exact'
unset multiplot
