# Review figure 40: a ring on a rigid floor is crushed by a rigid platen; von Mises stress, and the force on three grids beside the
# elastica's.
load 'style.gnuplot'
set terminal pngcairo size 1500,1040 font ',19'
set output 'smashed_ring.png'
nu = 0.3  # of the scene's defaults
von_mises(xx, yy, xy) = sqrt(xx**2 + yy**2 - xx*yy + 3*xy**2 + (nu**2 - nu)*(xx + yy)**2)  # plane strain, szz = nu (sxx + syy)
fine = 'data/ring-64/particles_'

set multiplot title 'A ring crushed by a rigid platen (MUSL, cubic B-splines)'
# Frames are 5 apart in time; after 30 the platen has come down by (t - 15)/100.
array frame[4] = [0, 7, 11, 15]
array percent[4] = [0, 20, 40, 60]
set xrange [-0.82:0.82]
set yrange [-0.17:1.2]
set size ratio 1.37/1.64
set xtics -0.5,0.5
set ytics 0,1
unset key
set cbrange [0:250]
set palette defined (0 '#e4e4e4', 0.35 '#7fb3d5', 0.7 '#e08a3c', 1 '#7a0c0c')
unset colorbox
set lmargin 0
set rmargin 0
set xlabel 'x [length]' offset 0,0.6
set label 1 'y [length]' at screen 0.02,0.755 center rotate by 90
set label 2 'von Mises stress [stress]' at screen 0.988,0.755 center rotate by 90
do for [i=1:4] {
    set origin 0.055 + 0.212*(i - 1), 0.55
    set size 0.205,0.42
    if (i == 2) { unset label; set format y '' }
    if (i == 4) { set colorbox user origin 0.915,0.645 size 0.014,0.22; set cbtics 100 }
    set title sprintf('%d %% of the diameter', percent[i])
    file = sprintf('%s%04d.csv', fine, frame[i])
    plot file using (column('body') > 0 ? column('x') : 1/0):(column('y')) with points pt 7 ps 0.3 lc rgb '#909090', \
         file using (column('body') == 0 ? column('x') : 1/0):(column('y')):(von_mises(column('sxx'), column('syy'), column('sxy'))) \
             with points pt 7 ps 0.3 lc palette
}
set origin 0.055,0.02
set size noratio 0.92,0.55
set format y
set title 'Force of the platen, averaged over 0.6 % of the diameter'
set xlabel 'displacement of the platen / diameter [-]'
set ylabel 'force [force/length]' offset 0.5,0
set xrange [0:0.6]
set yrange [-0.2:6.2]
set xtics 0.1
set ytics 0,1
set key top left
ring(n) = 'data/ring-'.n.'/history.csv'
plot ring('16') using (column('displacement')):(column('force_platen')) with lines lt 4 lw 1.5 title '16 cells across the ring', \
     ring('32') using (column('displacement')):(column('force_platen')) with lines lt 3 dt solid lw 1.5 title '32 cells', \
     ring('64') using (column('displacement')):(column('force_platen')) with lines lt 2 dt solid lw 2 title '64 cells', \
     ring('64') using (column('displacement')):(column('force_elastica')) with lines lt 1 title 'thin inextensible ring (elastica)', \
     ring('64') using (column('displacement')):(column('force_beam')) \
         with lines lt 1 dt (8,4) lw 1.5 title 'curved beam, small displacements'
unset multiplot
