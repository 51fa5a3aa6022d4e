# Where does implicit win: CPU time of the cheapest run within a stated error, as the stiffness grows (runs/stiffness.sh makes the table).
load 'style.gnuplot'
set terminal pngcairo size 1500,1250 font ',20'
set output 'implicit_stiffness.png'
cheapest(scene, method, most) = sprintf("< awk -F, '$1 == \"%s\" && $3 ~ /^%s/ && $5 <= %g && (!($2 in t) || $6 < t[$2]) { t[$2] = $6; m[$2] = $7 } ".\
    "END { for (s in t) print s \",\" t[s] \",\" m[s] }' implicit_stiffness.csv | sort -g", scene, method, most)
# Gnuplot warns of what has no points: MUSL in the cantilever, which swings so little that it is TLMPM, and estimates in the uniform bar.
set multiplot layout 2,2 title 'CPU time to reach a stated error, explicit and implicit' margins 0.09,0.98,0.08,0.86 spacing 0.09,0.16
set logscale xy
set format '10^{%L}'
set xrange [0.5:2e8]
set xtics 1e2
set ylabel 'CPU time [s]'
scenes = 'bar stiff-bar column cantilever'
array titles[4] = ['uniform bar, one period, to 0.2 %', 'bar with a stiffer half, one period, to 0.2 %', 'column, loaded in 1 s, to 0.1 %', \
    'cantilever with a stiffer end, 3 s, to 2 %']
array xs[4] = ['modulus over the first [-]', 'modulus of the outer half over the inner [-]', 'modulus and load over the first [-]', \
    'modulus of the end over the rest [-]']
array most[4] = [2e-3, 2e-3, 1e-3, 2e-2]
array low[4] = [3e-5, 3e-5, 1e-4, 3e-2]
array high[4] = [1e-1, 1e2, 1e2, 1e3]
do for [i = 1:4] {
    scene = word(scenes, i)
    set title titles[i]
    set xlabel xs[i]
    set yrange [low[i]:high[i]]
    if (i == 1) { set key at screen 0.5,0.925 center maxrows 1 samplen 3 } else { unset key }
    plot cheapest(scene, 'implicit', most[i]) using 1:2 with linespoints lt 1 pt 7 ps 1.8 title 'implicit', \
         cheapest(scene, 'musl', most[i]) using 1:($3 == 1 ? $2 : NaN) with linespoints lt 2 pt 6 ps 1.8 title 'MUSL', \
         cheapest(scene, 'tlmpm', most[i]) using 1:($3 == 1 ? $2 : NaN) with linespoints lt 3 pt 4 ps 1.8 title 'TLMPM', \
         cheapest(scene, 'tlmpm', most[i]) using 1:($3 == 0 ? $2 : NaN) with points lt 3 pt 10 ps 2 title 'TLMPM, estimated'
}
unset multiplot
