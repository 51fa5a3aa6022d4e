# Rings and disks that meet: snapshots around the contact, energies with the review's time step, contact under refinement.
for n in 16 32; do run ring-$n smashed_ring --cells $n; done
run ring-64 smashed_ring --cells 64 --cfl 0.6 --frames 15
for cells in 25 50 100; do
    frames=0; [ $cells = 50 ] && frames=4
    run steel-disk-$cells steel_disk --cells $cells --records 400 --frames $frames
done
run disks-snapshots two_disks --cells 40 --frames 18
for shape in hat cubic; do
    for scheme in usl usf musl; do run disks-$scheme-$shape two_disks --scheme $scheme --shape $shape --dt 1e-3 --records 700; done
    cells=20,40,80; [ $shape = hat ] && cells=20,40,80,160
    run disks-contact-$shape two_disks --shape $shape --cells $cells --cfl 0.2 --t-end 1.65 --records 100
done
