# Variants side by side: error against run time of the segment, largest stable steps and stiff cases of the bar, the iMPM beside others,
# implicit beside explicit. An unstable run is a row (exit code 3).
compared() { run "$@" || [ $? -eq 3 ]; }
segment() { printf ' -- mms_segment --G 0.05 --ppc 2 --repeat 5 %s' "$*"; }
compared segment compare --cells 8,16,32,64,128 --clock cpu --fresh $(
    segment '--scheme fem'; segment '--scheme fem --shape lagrange'; segment '--scheme tlmpm'; segment '--scheme tlmpm --shape bernstein'
    segment '--scheme tlmpm --shape cubic'; segment '--scheme tlmpm --transfer apic'; segment '--scheme tlmpm --shape cubic --transfer fmpm --order 4'
    segment '--scheme tlmpm --shape cubic --transfer consistent --points gauss'; segment '--scheme usl'; segment '--scheme usl --shape cpgimp'
    segment '--scheme usl --shape cpgimp --transfer fmpm'; segment '--scheme usl --shape cubic'; segment '--scheme impm')
cp "$figures/data/segment/work_precision.png" "$figures/segment_work_precision.png"
cp "$figures/data/segment/convergence.png" "$figures/segment_convergence.png"
bar() { program=$1; shift; printf ' -- %s --ppc 2 --periods 2 --repeat 3 %s' "$program" "$*"; }
disks() { program=$1; shift; printf ' -- %s --cfl 0.2 --t-end 1.65 --records 100 %s' "$program" "$*"; }
compared impm-bar compare --cells 16,32,64,128 --clock cpu --fresh $(
    bar musl_bar; bar tlmpm_bar; bar tlmpm_bar --shape cubic; bar tlmpm_bar --transfer apic
    bar tlmpm_bar --shape cubic --transfer fmpm --order 4; bar impm_bar; bar impm_bar --gradient hat)
compared impm-disks compare --cells 20,40,80 --clock cpu --fresh $(
    disks two_disks; disks two_disks --shape cubic; disks two_disks --transfer apic; disks two_disks --transfer fmpm --order 4
    disks impm_disks)
for scene in bar disks; do cp "$figures/data/impm-$scene/work_precision.png" "$figures/impm-${scene}_work_precision.png"; done
run stability stability --tolerance 0.05 --contrast 1,1e2 --finest 256 -- contrast_bar --scheme usl \
    -- contrast_bar --scheme usf -- contrast_bar --scheme musl -- contrast_bar --scheme tlmpm -- contrast_bar --scheme tlmpm --transfer apic \
    -- contrast_bar --scheme tlmpm --transfer fmpm -- contrast_bar --scheme musl --shape cubic -- contrast_bar --scheme usl --shape cpgimp
cp "$figures/data/stability/stability_steps.png" "$figures/data/stability/stability_map.png" "$figures"
for c in 1 1e4 1e6; do
    run implicit-contrast-$c implicit_contrast_bar --contrast $c --cells 16,32,64 --repeat 3
    cells=16,32,64; [ $c = 1e6 ] && cells=8,16
    for scheme in musl tlmpm; do run $scheme-contrast-$c contrast_bar --scheme $scheme --contrast $c --cells $cells --cfl 0.5 --records 100; done
done
