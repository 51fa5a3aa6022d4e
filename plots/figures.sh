#!/bin/sh
# figures.sh BUILD FIGURES: runs the programs of the figures and draws every recipe of this folder.
set -eu
build=$(cd "$1" && pwd); plots=$(cd "$(dirname "$0")" && pwd); mkdir -p "$2"; figures=$(cd "$2" && pwd)
run() {
    name=$1; shift; echo "running" $*; program=$1; shift
    mkdir -p "$figures/data/$name" && echo $program $* >"$figures/data/$name/command"  # the gallery shows it
    "$build/$program" --quiet --out "$figures/data/$name" "$@"
}
run mode1-flip usl_bar --cells 16 --ppc 2
run mode1-pic usl_bar --cells 16 --ppc 2 --alpha 0
for scheme in usl usf musl tlmpm; do run mode10-$scheme ${scheme}_bar --mode 10 --records 8000; done
run musl_bar-mode-1 musl_bar --plot png
run musl_bar-mode-10 musl_bar --mode 10 --plot png
run basis-hat basis_functions --shape hat --cells 3
for l in 1 0.5 0.25 0.1; do run basis-gimp-$l basis_functions --shape ugimp --l $l; done
run basis-cubic basis_functions --shape cubic --cells 5
run basis-bernstein basis_functions --shape bernstein --cells 3
run basis-bernstein-1 basis_functions --shape bernstein --cells 1
# The manufactured segment; a run that becomes unstable (exit code 3) is a row too.
segment() {
    variant=$1; cells=$2; shift 2
    for G in 1e-4 0.05; do run "segment-$variant-$G" mms_segment --G $G --cells $cells --ppc 2 --records 10 --watch warn "$@" || [ $? -eq 3 ]; done
}
for shape in hat cubic bernstein; do segment tlmpm-$shape 4,8,16,32,64,128,256 --scheme tlmpm --shape $shape; done
for scheme in musl usf; do segment $scheme-hat 4,8,16,32,64,128,256 --scheme $scheme; done
for shape in ugimp cubic; do segment usl-$shape 4,8,16,32,64,128,256 --scheme usl --shape $shape; done
for scheme in usl musl; do segment $scheme-cpgimp 4,8,16,32,64,128,256,512 --scheme $scheme --shape cpgimp; done
segment fem 4,8,16,32,64,128,256,512 --scheme fem
# The manufactured square; the vortex as printed and better, and one setting after the other; on two cores.
square() { name=$1; shift; run square-$name mms_square --points gauss --cells 8,16,32,64 --records 10 "$@"; }
vortex() { name=$1; shift; run vortex-$name vortex --points gauss --cfl 0.93 --records 10 "$@"; }
printed='--force nodes --cut whole --start whole --alpha 0.99'
plane() {
    for shape in hat cubic bernstein; do
        ppc=2; [ $shape = bernstein ] && ppc=3
        square $shape-1e-4 --shape $shape --ppc $ppc --G 1e-4 --cfl 0.2325
        square $shape-0.05 --shape $shape --ppc $ppc --G 0.05 --cfl 0.2765
        square printed-$shape --shape $shape --ppc $ppc --G 0.05 --cfl 0.2765 --force nodes --alpha 0.99
    done
    vortex printed-hat --shape hat --cells 50,100,200 $printed
    vortex printed-bernstein --shape bernstein --ppc 3 --cells 50,100 $printed
    vortex bernstein --shape bernstein --ppc 3 --cells 50,100
    vortex ring --shape bernstein --ppc 3 --cells 76 --t-end 0.5 --frames 1
}
plane &
vortex printed-cubic --shape cubic --cells 50,100,200 $printed
vortex cubic --shape cubic --cells 50,100,200
vortex particles --shape cubic --cells 50,100 --cut whole --start whole --alpha 0.99
vortex fmpm --shape cubic --cells 50,100 --transfer fmpm --order 5
run vortex-steps vortex --shape cubic --points gauss --cfl 0.465 --records 10 --cells 50,100 $printed
wait $!
run crossing-1 cell_crossing
run crossing-3 cell_crossing --ppc 3 --offset 0.05
for cfl in 0.12 0.06 0.03 0.015 0.0075; do run crossing-cfl-$cfl cell_crossing --ppc 3 --offset 0.05 --cfl $cfl; done
run projection-review velocity_projection --cells 3 --ppc 1
run projection-shifted velocity_projection --ppc 3 --jitter 0.8
for k in 1 2 4 8 16 32 64; do run projection-fmpm-$k velocity_projection --ppc 3 --jitter 0.8 --transfer fmpm --order $k; done
# Moving least squares and the iMPM.
run mls-linear mls_approximation
run mls-sine mls_approximation --function sine --points 0 --cells 20,40,80,160
for G in 0.05 1e-4; do
    cfl=0.2765; [ $G = 1e-4 ] && cfl=0.2325  # 0.2 h/c
    impm="mms_segment --scheme impm --ppc 2 --records 10 --watch warn --G $G --cfl $cfl"
    run impm-linear-1.1-$G $impm --cells 16,32,64,128,256,512
    if [ $G = 0.05 ]; then for d in 1.1 1.5; do run impm-hat-$d-$G $impm --cells 16,32,64,128,256,512 --gradient hat --limit 1e4 --support $d || [ $? -eq 3 ]; done; fi
done
for d in 1.01 1.5; do run impm-noise-$d impm_noise --support $d --cells 32,64,128,256; done
run impm-noise-1.1 impm_noise --cells 32,64,128,256,512
for q in centre gauss; do run beam-$q impm_cantilever --quadrature $q --periods 1 --frames 1 --watch warn || [ $? -eq 3 ]; done
for case in cells bounds mesh voronoi image; do
    run fill-$case fill_demo --case $case --plot png
    cp "$figures/data/fill-$case/fill_$case.png" "$figures"
done
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
for n in 16 32; do run ring-$n smashed_ring --cells $n; done
run ring-64 smashed_ring --cells 64 --cfl 0.6 --frames 15
# Full order of the basis: consistent mass, steps so small that the leapfrog's error does not show.
for shape in hat bernstein cubic; do
    ppc=2; [ $shape = bernstein ] && ppc=3
    run order-$shape mms_segment --scheme tlmpm --shape $shape --transfer consistent --points gauss --ppc $ppc --cfl 0.0116 --cells 4,8,16,32
done
run order-lumped mms_segment --scheme tlmpm --shape cubic --points gauss --ppc 2 --cfl 0.0116 --cells 4,8,16,32
run order-fem mms_segment --scheme fem --ppc 2 --cfl 0.0116 --cells 4,8,16,32
for cells in 25 50 100; do
    frames=0; [ $cells = 50 ] && frames=4
    run steel-disk-$cells steel_disk --cells $cells --records 400 --frames $frames
done

# Two disks: snapshots around the contact, energies with the review's time step, contact under refinement.
run disks-snapshots two_disks --cells 40 --frames 18
for shape in hat cubic; do
    for scheme in usl usf musl; do run disks-$scheme-$shape two_disks --scheme $scheme --shape $shape --dt 1e-3 --records 700; done
    cells=20,40,80; [ $shape = hat ] && cells=20,40,80,160
    run disks-contact-$shape two_disks --shape $shape --cells $cells --cfl 0.2 --t-end 1.65 --records 100
done

# CPDI: domains of a heavy column before they get too long; the hole, a named trouble (exit code 3) where nothing is done about it.
for d in r4 q4 t3 polygon; do run cpdi-column-$d cpdi_${d}_column --g 1000 --cells 8 --ppc 1 --t-end 0.036 --frames 1 --records 20; done
run cpdi-hole-wide cpdi_hole --watch warn --frames 6 || [ $? -eq 3 ]
run cpdi-hole-narrow cpdi_hole --wide 2.8 --frames 6
run cpdi-hole-split cpdi_hole --split --frames 6
# Particle domains: the pressed cylinder, the sheared ring, the two disks.
for s in q4 t3 polygon; do
    cells=20,40,80; [ $s = polygon ] && cells=20,40
    run cylinder-$s cpdi_cylinder --shape cpdi-$s --cells $cells --frames 1
done
for d in conforming boxes; do run domains-$d cpdi_vortex --domains $d --ppc 2 --frames 2 --watch warn || [ $? -eq 3 ]; done
for s in r4 q4 t3 polygon; do run domains-disks-$s cpdi_two_disks --shape cpdi-$s --cells 40 --t-end 3.8 --frames 2; done

# Heat: the bar of figure 51 and the plate of figure 52, line 10 as printed and mended.
for form in printed mended; do
    run heat-bar-$form heat_bar --form $form --ppc 2 --dt 8e-5 --frames 20 --records 50
    run heat-bar-$form-cells heat_bar --form $form --ppc 2 --cells 10,20,40,80,160 --records 10
done
run heat-bar heat_bar --dt 8e-5 --frames 20 --records 50
run heat-plate heat_plate --dt 1e-4 --frames 1 --records 50
run heat-plate-cells heat_plate --cells 10,20,40 --records 10
run heat-plate-cells-printed heat_plate --form printed --cells 10,20,40 --records 10

# Thermo-mechanics: a clamped bar, a free plate, a sheared block.
run thermal-bar thermal_bar_clamped --records 500
run thermal-plate thermal_expansion --records 200
run thermal-plate-rest thermal_expansion --start rest --records 200
for H in 0 500e6; do run adiabatic-$H adiabatic_shear --H $H --cells 3 --cfl 0.5 --records 100; done
# Gases and liquids: the shock tube as in the review, with smooth functions, refined, in motion.
run sod-hat-plain shock_tube --c0 0 --c1 0 --frames 1
for s in hat cpgimp; do run sod-$s shock_tube --shape $s --frames 1; done
for s in hat cpgimp cubic; do run sod-order-$s shock_tube --shape $s --cells 100,200,400,800,1200 --records 20; done
run sod-cpgimp-film shock_tube --shape cpgimp --frames 40
run dam dam_break --frames 85
run dam-barrier dam_break --barrier 0.5 --frames 34
for s in hat cubic; do
    run dam-front-$s dam_break --length 1 --height 2 --box 5 --cells 40 --t-end 0.7 --shape $s
    run dam-front-$s-stiff dam_break --length 1 --height 2 --box 5 --cells 40 --t-end 0.7 --shape $s --kappa 1.2e8
done
for flow in couette poiseuille; do
    run channel-$flow channel --flow $flow --cells 16 --t-end 0.2 --frames 4
    for s in hat cubic; do run channel-$flow-$s channel --flow $flow --shape $s --cells 4,8,16,32; done
done
run column hydrostatic --frames 1
run column-cubic hydrostatic --shape cubic --frames 1
# Contact: a block and a disk on a slope, every way to make normals with every test of the gap (a run that becomes unstable is a row too).
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

# Locking: the cantilever with and without F-bar for Poisson's ratios up to 0.49999, and the pressure of Cook's membrane.
for nu in 0.3 0.49 0.499 0.4999 0.49999; do
    run locking-off-$nu fbar_cantilever --fbar off --nu $nu --records 200
    run locking-moving-$nu fbar_cantilever --nu $nu --records 200
    run locking-tlmpm-$nu fbar_cantilever --scheme tlmpm --nu $nu --records 200
done
run locking-grid-0.499 fbar_cantilever --fbar grid --watch warn --records 200 || [ $? -eq 3 ]
for fbar in off grid moving; do
    run cook-$fbar fbar_block --fbar $fbar --shape ugimp --t-end 14.8 --frames 1 --records 100 --watch warn || [ $? -eq 3 ]
done

# Variants side by side: error against run time of the segment, largest stable steps and stiff cases of the bar.
segment() { printf ' -- mms_segment --G 0.05 --ppc 2 --repeat 5 %s' "$*"; }
run segment compare --cells 8,16,32,64,128 --fresh $(
    segment '--scheme fem'; segment '--scheme fem --shape lagrange'; segment '--scheme tlmpm'; segment '--scheme tlmpm --shape bernstein'
    segment '--scheme tlmpm --shape cubic'; segment '--scheme tlmpm --transfer apic'; segment '--scheme tlmpm --shape cubic --transfer fmpm --order 4'
    segment '--scheme tlmpm --shape cubic --transfer consistent --points gauss'; segment '--scheme usl'; segment '--scheme usl --shape cpgimp'
    segment '--scheme usl --shape cpgimp --transfer fmpm'; segment '--scheme usl --shape cubic'; segment '--scheme impm')
cp "$figures/data/segment/work_precision.png" "$figures/segment_work_precision.png"
cp "$figures/data/segment/convergence.png" "$figures/segment_convergence.png"
run stability stability --tolerance 0.05 --contrast 1,1e2 --finest 256 -- contrast_bar --scheme usl \
# The iMPM beside others: the bar's frequency, the moment of the disks' contact.
bar() { program=$1; shift; printf ' -- %s --ppc 2 --periods 2 --repeat 3 %s' "$program" "$*"; }
disks() { program=$1; shift; printf ' -- %s --cfl 0.2 --t-end 1.65 --records 100 %s' "$program" "$*"; }
echo "comparing the iMPM with others on the bar and the disks"
"$build/compare" --cells 16,32,64,128 --quiet --fresh --out "$figures/data/impm-bar" $(
    bar musl_bar; bar tlmpm_bar; bar tlmpm_bar --shape cubic; bar tlmpm_bar --transfer apic
    bar tlmpm_bar --shape cubic --transfer fmpm --order 4; bar impm_bar; bar impm_bar --gradient hat)
"$build/compare" --cells 20,40,80 --quiet --fresh --out "$figures/data/impm-disks" $(
    disks two_disks; disks two_disks --shape cubic; disks two_disks --transfer apic; disks two_disks --transfer fmpm --order 4
    disks impm_disks --watch warn)
for scene in bar disks; do cp "$figures/data/impm-$scene/work_precision.png" "$figures/impm_${scene}_work_precision.png"; done
echo "looking for the largest stable steps"
"$build/stability" --quiet --tolerance 0.05 --contrast 1,1e2 --finest 256 --out "$figures/data/stability" -- contrast_bar --scheme usl \
    -- contrast_bar --scheme usf -- contrast_bar --scheme musl -- contrast_bar --scheme tlmpm -- contrast_bar --scheme tlmpm --transfer apic \
    -- contrast_bar --scheme tlmpm --transfer fmpm -- contrast_bar --scheme musl --shape cubic -- contrast_bar --scheme usl --shape cpgimp
cp "$figures/data/stability/stability_steps.png" "$figures/data/stability/stability_map.png" "$figures"

export GNUPLOT_LIB="$plots"
for recipe in "$plots"/*.gp; do
    name=$(basename "$recipe" .gp)
    (cd "$figures" && gnuplot "$recipe") || { echo "gnuplot failed on $recipe" >&2; exit 1; }
    echo "drew $name in $figures"
done
"$build/gallery" --plots "$plots" --figures "$figures"
