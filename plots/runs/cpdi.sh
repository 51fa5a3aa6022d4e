# Particle domains. The hole is a named trouble (exit code 3) where nothing is done about it.
for d in r4 q4 t3 polygon; do run cpdi-column-$d cpdi_${d}_column --g 1000 --cells 8 --ppc 1 --t-end 0.036 --frames 1 --records 20; done
run cpdi-hole-wide cpdi_hole --watch warn --frames 6 || [ $? -eq 3 ]
run cpdi-hole-narrow cpdi_hole --wide 2.8 --frames 6
run cpdi-hole-split cpdi_hole --split --frames 6
for s in q4 t3 polygon; do
    cells=20,40,80; [ $s = polygon ] && cells=20,40
    run cylinder-$s cpdi_cylinder --shape cpdi-$s --cells $cells --frames 1
done
for d in conforming boxes; do run domains-$d cpdi_vortex --domains $d --ppc 2 --frames 2 --watch warn || [ $? -eq 3 ]; done
for s in r4 q4 t3 polygon; do run domains-disks-$s cpdi_two_disks --shape cpdi-$s --cells 40 --t-end 3.8 --frames 2; done
