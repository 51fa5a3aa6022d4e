#!/bin/sh
# figures.sh BUILD FIGURES: runs the programs of the figures and draws every recipe of this folder. `figures.sh BUILD FIGURES NAME` runs those of
# runs/NAME.sh alone and draws nothing.
set -eu
build=$(cd "$1" && pwd); plots=$(cd "$(dirname "$0")" && pwd); mkdir -p "$2"; figures=$(cd "$2" && pwd)
run() {
    name=$1; shift; echo "running" $*; program=$1; shift
    mkdir -p "$figures/data/$name" && echo $program $* >"$figures/data/$name/command"  # the gallery shows it
    "$build/$program" --quiet --out "$figures/data/$name" "$@"
}
if [ $# -gt 2 ]; then . "$plots/runs/$3.sh"; exit 0; fi

# One chapter a core, the longest first; then those whose times count, alone.
printf '%s\n' vortex contact disks fluid square implicit cpdi segment improved locking thermal explicit filling weighting |
    xargs -P "$(nproc)" -n 1 "$0" "$build" "$figures"
for name in column compared; do "$0" "$build" "$figures" $name; done
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

# Variants side by side: error against run time of the segment, largest stable steps and stiff cases of the bar.
segment() { printf ' -- mms_segment --G 0.05 --ppc 2 --repeat 5 %s' "$*"; }
echo "comparing variants of mms_segment"
"$build/compare" --cells 8,16,32,64,128 --quiet --fresh --out "$figures/data/segment" $(
    segment '--scheme fem'; segment '--scheme fem --shape lagrange'; segment '--scheme tlmpm'; segment '--scheme tlmpm --shape bernstein'
    segment '--scheme tlmpm --shape cubic'; segment '--scheme tlmpm --transfer apic'; segment '--scheme tlmpm --shape cubic --transfer fmpm --order 4'
    segment '--scheme tlmpm --shape cubic --transfer consistent --points gauss'; segment '--scheme usl'; segment '--scheme usl --shape cpgimp'
    segment '--scheme usl --shape cpgimp --transfer fmpm'; segment '--scheme usl --shape cubic'; segment '--scheme impm')
cp "$figures/data/segment/work_precision.png" "$figures/segment_work_precision.png"
cp "$figures/data/segment/convergence.png" "$figures/segment_convergence.png"
# The iMPM beside others: the bar's frequency, the moment of the disks' contact.
bar() { program=$1; shift; printf ' -- %s --ppc 2 --periods 2 --repeat 3 %s' "$program" "$*"; }
disks() { program=$1; shift; printf ' -- %s --cfl 0.2 --t-end 1.65 --records 100 %s' "$program" "$*"; }
echo "comparing the iMPM with others on the bar and the disks"
"$build/compare" --cells 16,32,64,128 --quiet --fresh --out "$figures/data/impm-bar" $(
    bar musl_bar; bar tlmpm_bar; bar tlmpm_bar --shape cubic; bar tlmpm_bar --transfer apic
    bar tlmpm_bar --shape cubic --transfer fmpm --order 4; bar impm_bar; bar impm_bar --gradient hat)
"$build/compare" --cells 20,40,80 --quiet --fresh --out "$figures/data/impm-disks" $(
    disks two_disks; disks two_disks --shape cubic; disks two_disks --transfer apic; disks two_disks --transfer fmpm --order 4
    disks impm_disks)
for scene in bar disks; do cp "$figures/data/impm-$scene/work_precision.png" "$figures/impm_${scene}_work_precision.png"; done
echo "looking for the largest stable steps"
"$build/stability" --quiet --tolerance 0.05 --contrast 1,1e2 --finest 256 --out "$figures/data/stability" -- contrast_bar --scheme usl \
    -- contrast_bar --scheme usf -- contrast_bar --scheme musl -- contrast_bar --scheme tlmpm -- contrast_bar --scheme tlmpm --transfer apic \
    -- contrast_bar --scheme tlmpm --transfer fmpm -- contrast_bar --scheme musl --shape cubic -- contrast_bar --scheme usl --shape cpgimp
cp "$figures/data/stability/stability_steps.png" "$figures/data/stability/stability_map.png" "$figures"

# Recipes go with the figures, so that each can be drawn again there.
cp "$plots"/*.gp "$plots"/*.csv "$plots"/style.gnuplot "$figures"
for recipe in "$plots"/*.gp; do
    name=$(basename "$recipe" .gp)
    (cd "$figures" && gnuplot "$name.gp") || { echo "gnuplot failed on $recipe" >&2; exit 1; }
    echo "drew $name in $figures"
done
"$build/gallery" --plots "$plots" --figures "$figures"
