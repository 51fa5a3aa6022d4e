# A block slides and a disk rolls down a slope of 30 degrees (friction 0.3, h = 0.1): contact as printed, with one normal for both bodies and a gap of
# extrapolated positions, and with normals by regression and the particles' extents, against the rigid bodies. Gravity comes on in 0.2.
load 'style.gnuplot'
set terminal pngcairo size 1400,620 font ',18'
set output 'contact_slope.png'
array name[3] = ['as printed', 'volume, position', 'regression, extent']
set multiplot layout 1,2 title 'Contact on a slope of 30 degrees, friction 0.3, h = 0.1'
set xlabel 'time t [time]'
set ylabel 'travel [length]'
set key left top Left reverse spacing 1.1
set datafile missing NaN
do for [p in 'sliding_block rolling_disk'] {
    set title (p eq 'sliding_block' ? 'Block' : 'Disk')
    plot for [i = 1:3] 'data/contact-'.p.'-aligned-'.word('printed-velocity volume-position regression-extent', i).'/history.csv' using (column('t')):(column('travel')) \
         with lines lw 3 dt i + 1 lc rgb word('#d55e00 #0072b2 #009e73', i) title name[i], \
         'data/contact-'.p.'-aligned-regression-extent/history.csv' using (column('t')):(column('travel_exact')) with lines lw 2 dt solid lc rgb 'black' title 'rigid body'
}
unset multiplot
