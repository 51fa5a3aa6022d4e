# A block and a disk on a slope, every way to make normals with every test of the gap (a run that becomes unstable is a row too); bodies that collide.
for p in sliding_block rolling_disk; do for g in aligned inclined; do for way in printed volume density regression; do for gap in velocity position extent; do
    normals="--normals $way"; [ $way = printed ] && normals='--scheme usf --normals gradient --common off'
    run contact-$p-$g-$way-$gap $p --grid $g $normals --gap $gap --ppc 2 --t-end 1 --records 40 --watch warn || [ $? -eq 3 ]
done; done; done; done
for p in sliding_block rolling_disk; do for g in aligned inclined; do run contact-$p-$g-fine $p --grid $g --cells 20 --t-end 1 --records 40; done; done
run contact-normals grid_normals
run contact-normals-slab grid_normals --beside slab
for c in coulomb frictionless; do run contact-disks-$c two_disks_contact --contact $c --records 300; done
run contact-disks-shared two_disks_contact --field shared --records 300
run contact-disks-printed two_disks_contact --normals gradient --common off --gap velocity --records 300 --watch warn || [ $? -eq 3 ]
run contact-bars head_on_bars --cells 25,50,100,200 --records 400
run contact-wall disk_on_wall --cells 10,20 --records 300
run contact-patch contact_patch
run contact-patch-whole contact_patch --whole
