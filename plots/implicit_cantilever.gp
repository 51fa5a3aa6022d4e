# The source's figures 7 and 8: the bent beam with the flags M_E at J = 2, and the swinging tip; what the published form loses.
load 'style.gnuplot'
set terminal pngcairo size 1500,1250 font ',20'
set output 'implicit_cantilever.png'
set multiplot title 'Cantilever, released from its own weight, steps of 0.008 s'
set origin 0,0.5
set size 1,0.46
set size ratio -1
set title 'flags M_E (0: no particles) and particles at t = 0.4 s, J = 2'
set xlabel 'x [m]'
set ylabel 'y [m]'
set xrange [0:1]
set yrange [-0.5:0.5]
set palette defined (0 '#ffffff', 1 '#d9e6f2', 3 '#a6c8e0', 6 '#5a9bc9', 9 '#2a6496')
set cbrange [0:9]
set cblabel 'M_E [-]'
unset key
plot 'data/implicit-cantilever-8/domains_0001.csv' using (column('x')):(column('y')):(column('flag')) with filledcurves closed fc palette, \
     'data/implicit-cantilever-8/domains_0001.csv' using (column('x')):(column('y')) with lines lc rgb '#aaaaaa' lw 1 dt solid, \
     'data/implicit-cantilever-8/particles_0001.csv' using (column('x')):(column('y')) with dots lc rgb '#d55e00'
set size noratio
set origin 0,0
set size 0.62,0.5
set title 'displacement of the tip'
set xlabel 'time t [s]'
set ylabel 'displacement [m]'
set xrange [0:4]
set xtics 1
set yrange [-0.4:0.8]
set key inside top right Left reverse samplen 3
plot 'data/implicit-cantilever-8/history.csv' using (column('t')):(column('tip')) with lines lt 1 title 'J = 2', \
     'data/implicit-cantilever-16/history.csv' using (column('t')):(column('tip')) with lines lt 2 title 'J = 3', \
     'data/implicit-cantilever-midpoint/history.csv' using (column('t')):(column('tip')) with lines lt 3 title 'J = 3, midpoint'
set origin 0.62,0
set size 0.38,0.5
set title 'energy since the release'
set ylabel 'part of that at the release [-]'
set yrange [0.78:1.02]
unset key
stats_of(name) = system("awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i } NR > 1 && $at[\"gravity\"] == 0 { print $at[\"total\"]; exit }' data/implicit-cantilever-".name."/history.csv") + 0
array start[3] = [stats_of("8"), stats_of("16"), stats_of("midpoint")]
free(i) = column('gravity') == 0 ? column('total') / start[i] : NaN
plot for [i = 1:3] 'data/implicit-cantilever-'.word('8 16 midpoint', i).'/history.csv' using (column('t')):(free(i)) with lines lt i
unset multiplot
