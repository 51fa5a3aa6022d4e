# The column of the total-Lagrangian report. Case C compares costs.
run column-a tlmpm_column --case A
run column-a-particle tlmpm_column --case A --position particle
run column-a-fem fem_column --case A --damping 0.1
cells=8,16,32,64,128
run column-b tlmpm_column --case B
run column-b-report tlmpm_column --case B --cells $cells
run column-b-neo tlmpm_column --case B --cells $cells --law neo-hookean
run column-b-flip tlmpm_column --case B --cells $cells --shape hat --alpha 1
run column-b-fem fem_column --case B --cells $cells --shape hat
run column-c-report tlmpm_column --case C --repeat 5
for start in uniform smooth; do
    c="--case C --shape hat --repeat 5 --start $start"
    run column-c-$start-mix tlmpm_column $c
    run column-c-$start-pic tlmpm_column $c --alpha 0
    run column-c-$start-flip tlmpm_column $c --alpha 1
    run column-c-$start-usl tlmpm_column $c --alpha 1 --stress usl
    run column-c-$start-apic tlmpm_column $c --transfer apic
    run column-c-$start-consistent tlmpm_column $c --transfer consistent
    for k in 2 5; do run column-c-$start-xpic$k tlmpm_column $c --transfer xpic --order $k; done
    for k in 2 4 8 16; do run column-c-$start-fmpm$k tlmpm_column $c --transfer fmpm --order $k; done
    run column-c-$start-fem fem_column $c
done
