# Review figures 72 and 73: domains of the ring that follow its edges or are boxes of the grid, at the start and at the largest angle (Q4, h = 0.05, a
# quadrant of it). Black circles: the ring's edges. As in the exact motion, domains beside the edges stay and those between shear.
load 'style.gnuplot'
set terminal pngcairo size 1500,1420 font ',19'
set output 'cpdi_vortex.png'
array folders[2] = ['domains-conforming', 'domains-boxes']
array names[2] = ['conforming to the edges', 'boxes of the grid']
array frame[2] = [0, 1]
array moments[2] = ['t = 0', 't = T_0/2']
set multiplot title 'Generalized vortex: particle domains (CPDI-Q4)'
set size ratio -1
set view map
set xrange [-0.02:1.38]
set yrange [-0.02:1.38]
set xtics 0.25
set ytics 0.25
unset key
unset grid
set pm3d border lc rgb '#404040' lw 0.6
set palette defined (0 '#f9dc7a', 0.35 '#f1844b', 0.7 '#a8327d', 1 '#1c0f5e')
set cbrange [0:24]
set cblabel 'von Mises stress [10^3 force/area]'
set style arrow 1 nohead lc rgb '#5fa8d3' lw 0.8
do for [k = 0:27] {
    c = 0.05*k
    set arrow from c,-0.02 to c,1.38 as 1 front
    set arrow from -0.02,c to 1.38,c as 1 front
}
set samples 100
W = 1500.0
H = 1420.0
set label 1 'y [length]' at screen 25/W,0.5 center rotate
p = 590
do for [row = 1:2] {
    do for [k = 1:2] {
        set lmargin at screen (110 + (k - 1)*(p + 30))/W
        set rmargin at screen (110 + (k - 1)*(p + 30) + p)/W
        set tmargin at screen 1 - (100 + (row - 1)*(p + 50))/H
        set bmargin at screen 1 - (100 + (row - 1)*(p + 50) + p)/H
        set title names[k].', '.moments[row] offset 0,-0.6
        set format y (k == 1 ? '%g' : '')
        set format x (row == 2 ? '%g' : '')
        set xlabel (row == 2 ? 'x [length]' : '') offset 0,0.4
        set colorbox user origin (110 + 2*p + 45)/W, 0.3 size 22/W, 0.4
        if (k + row > 2) { unset colorbox }
        splot sprintf('data/%s/domains_%04d.csv', folders[k], frame[row]) using (column('x')):(column('y')):(column('mises')/1e3) with polygons fc palette, \
              [t=0:pi/2] '+' using (0.75*cos($1)):(0.75*sin($1)):(0) with lines dt solid lw 2.5 lc rgb 'black', \
              [t=0:pi/2] '+' using (1.25*cos($1)):(1.25*sin($1)):(0) with lines dt solid lw 2.5 lc rgb 'black'
        unset label 1
    }
}
unset multiplot
