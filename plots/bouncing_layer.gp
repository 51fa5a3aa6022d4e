# How high the disk bounces, by the thickness of the layer of elements that it feels the plate from: measured once, as by `bouncing_disk --far 0.01 --soft-few 1e-5
# --receding 0 --carry midpoint --watch warn --t-end 1.2 --cells 32,64,128 --near 0.00025 --thin 1` (46,978 particles; J = 4, 0.000125: 140 CPU seconds a point). Beside it
# the explicit disk on a rigid wall at the same v/c: `disk_on_wall --v0 2.246 --nu 0.4 --watch warn --cells 20,40,80`, its rebound speed squared.
load 'style.gnuplot'
set terminal pngcairo size 1100,850 font ',18'
set output 'bouncing_layer.png'
set title 'First rebound of the disk by the thickness of its contact layer, C_c = 0'
set xlabel 'thickness of the layer of elements over the plate / R [-]'
set ylabel 'height / first height [-]'
set logscale x
set xrange [0.025:0.4]
set xtics ('1/32' 1/32., '1/16' 1/16., '1/8' 1/8., '1/4' 1/4.)
set yrange [0.76:1.02]
set key top left Left reverse samplen 3
set object 1 rectangle from graph 0, first 0.808 to graph 1, first 0.857 fillcolor rgb '#e4e4e4' fillstyle solid noborder behind
set label 1 'explicit disk on a rigid wall, 20 to 80 cells' at graph 0.98, first 0.832 right
height(J, near) = column('J') == J && abs(column('near')/near - 1) < 0.01 ? column('height') : NaN
layer = 'bouncing_layer.csv'
set datafile missing NaN
plot layer using (column('layer')/0.16):(height(2, 0.00025)) with linespoints lt 1 pt 7 ps 1.4 title 'J = 2, steps of 0.00025 s', \
     layer using (column('layer')/0.16):(height(3, 0.00025)) with linespoints lt 2 pt 9 ps 1.4 title 'J = 3, 0.00025 s', \
     layer using (column('layer')/0.16):(height(3, 0.000125)) with linespoints lt 2 pt 8 ps 1.4 dt solid title 'J = 3, 0.000125 s', \
     layer using (column('layer')/0.16):(height(4, 0.00025)) with linespoints lt 3 pt 5 ps 1.4 title 'J = 4, 0.00025 s', \
     layer using (column('layer')/0.16):(height(4, 0.000125)) with linespoints lt 3 pt 4 ps 1.4 dt solid title 'J = 4, 0.000125 s'
