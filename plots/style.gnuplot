# What the recipes of this folder share.
set encoding utf8
set datafile separator ','
set grid lc rgb '#dddddd' lt 1 lw 1
# Colours that differ in lightness, each with its own dash: curves can be told apart in print without colour.
set linetype 1 lc rgb '#000000' lw 2.5 dt solid
set linetype 2 lc rgb '#d55e00' lw 2.5 dt (8,3)
set linetype 3 lc rgb '#0072b2' lw 2.5 dt (2,4)
set linetype 4 lc rgb '#e69f00' lw 2.5 dt solid
set linetype 5 lc rgb '#009e73' lw 2.5 dt (8,3,2,3)
set linetype 6 lc rgb '#cc79a7' lw 2.5 dt (14,3)
