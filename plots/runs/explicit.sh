# The vibrating bar, and bodies that cross cells.
run mode1-flip usl_bar --cells 16 --ppc 2
run mode1-pic usl_bar --cells 16 --ppc 2 --alpha 0
for scheme in usl usf musl tlmpm; do run mode10-$scheme ${scheme}_bar --mode 10 --records 8000; done
run musl_bar-mode-1 musl_bar --plot png
run musl_bar-mode-10 musl_bar --mode 10 --plot png
run crossing-1 cell_crossing
run crossing-3 cell_crossing --ppc 3 --offset 0.05
for cfl in 0.12 0.06 0.03 0.015 0.0075; do run crossing-cfl-$cfl cell_crossing --ppc 3 --offset 0.05 --cfl $cfl; done
