#!/bin/sh
# atlas.sh BUILD FIGURES [quick]: every case that has an exact or a reference solution, with the variants that can run it, at several resolutions: error
# against CPU time. The gallery makes of it what to use when. What a sweep has finished is not run again. `atlas.sh BUILD FIGURES full|quick NAME` runs
# one case.
set -eu
build=$(cd "$1" && pwd); plots=$(cd "$(dirname "$0")" && pwd); mkdir -p "$2"; figures=$(cd "$2" && pwd); size=${3:-full}; only=${4:-}
cases="vortex square cylinder bar cantilever shock-tube segment sliding-block heat-plate channel heat-bar small-swing stiff-bar column head-on-bars bar-implicit"  # the longest first
# each 'words of all variants' 'words of one' 'words of another' ...: variants, as compare reads them.
each() { all=$1; shift; for words in "$@"; do printf ' -- %s %s' "$all" "$words"; done; }
# atlas NAME CLASS TITLE ERROR 'WHAT THE ERROR IS' CELLS QUICK-CELLS VARIANTS
atlas() {
    [ "$1" = "$only" ] || return 0
    folder=$figures/data/atlas-$1 name=$1
    cells=$6; [ "$size" != quick ] || cells=$7
    mkdir -p "$folder" && printf '%s\n%s\n%s\n' "$3" "$4" "$2" >"$folder/title"
    echo "./compare --cells $cells --error $4 --clock cpu$8" >"$folder/command"  # the gallery shows it
    # An unstable run or one that takes too long is a row of the table, and compare says 3.
    "$build/compare" --cells "$cells" --error "$4" --error-label "$5" --title "$3" --clock cpu --timeout 300 --quiet --out "$folder" $8 || [ $? -eq 3 ]
    times >"$folder/times"
    awk -v name="$name" -v cells="$cells" 'NR == 2 { split($1, part, /[ms]/); print "compared", name, "on", cells, "cells:", 60 * part[1] + part[2], "s CPU" }' \
        "$folder/times"
}

solids="Vibrating solids" large="Solids in large motion" heat="Conduction of heat" fluids="Gas and liquid" contact="Contact" pressed="Curved boundaries"
atlas bar "$solids" "Axial vibration of a bar, mode 1, 10 periods" frequency "relative error of the frequency [-]" 13,25,50,100,200 13,25,50 \
    "$(each "" "usl_bar --repeat 3" "usf_bar --repeat 3" "musl_bar --repeat 3" "tlmpm_bar --repeat 3" "musl_bar --shape cubic --repeat 3" \
        "musl_bar --shape cpgimp --repeat 3" "tlmpm_bar --shape cubic --repeat 3" "tlmpm_bar --shape bernstein --ppc 2 --repeat 3" \
        "tlmpm_bar --transfer apic --repeat 3" "tlmpm_bar --shape cubic --transfer fmpm --order 4 --repeat 3" "impm_bar --repeat 3" "fem_bar --repeat 3" \
        "cpdi_bar --repeat 3")"
atlas bar-implicit "$solids" "The same bar, steps up to 50 h/c" frequency "relative error of the frequency [-]" 13,25,50,100,200 13,25,50 \
    "$(each "" "musl_bar --cfl 0.5 --repeat 3" "tlmpm_bar --cfl 0.5 --repeat 3" "implicit_bar --cfl 0.5 --repeat 3" "implicit_bar --cfl 5 --repeat 3" \
        "implicit_bar --cfl 50 --repeat 3")"
atlas cantilever "$solids" "Swinging cantilever of 2807 particles, implicit, against beam theory with shear" frequency "relative error of the frequency [-]" 4,8,16 4,8 \
    "$(each "implicit_cantilever --layers 11 --t-end 4" "--carry particle" "--carry midpoint" "--carry conserving" "--carry particle --gamma 0.6 --beta 0.3025")"
atlas stiff-bar "$solids" "A bar whose outer half is 1e4 times stiffer, one period" frequency "relative error of the frequency [-]" 8,16,32,64 8,16 \
    "$(each "" "contrast_bar --scheme musl --contrast 1e4 --cfl 0.5" "contrast_bar --scheme tlmpm --contrast 1e4 --cfl 0.5" \
        "implicit_contrast_bar --contrast 1e4 --steps 50" "implicit_contrast_bar --contrast 1e4 --steps 200")"
atlas column "$solids" "A column, loaded in a second, comes to rest" u_static "relative error of the end's displacement [-]" 5,10,20,40 5,10,20 \
    "$(each "" "resting_column --scheme musl --ramp 1" "resting_column --scheme tlmpm --ramp 1" "implicit_column --ramp 1 --dt 0.1")"
swing="--rows 10 --layers 5 --g 0.01 --t-end 3 --reference 1.3464"
atlas small-swing "$solids" "A short cantilever swings a little, explicit and implicit" frequency "relative error of the frequency [-]" 8,16,32 8,16 \
    "$(each "" "cantilever --scheme musl $swing" "cantilever --scheme tlmpm $swing" "cantilever --scheme tlmpm --shape hat $swing" \
        "implicit_cantilever $swing")"
atlas segment "$large" "Manufactured segment, displacements of 5 % of its length" e2 "relative error of the displacement, e2 [-]" \
    8,16,32,64,128,256 8,16,32,64 "$(each "mms_segment --G 0.05 --ppc 2 --repeat 3" "--scheme fem" "--scheme tlmpm" "--scheme tlmpm --shape cubic" \
        "--scheme tlmpm --shape bernstein" "--scheme tlmpm --transfer apic" "--scheme tlmpm --shape cubic --transfer consistent --points gauss" \
        "--scheme usl" "--scheme usf" "--scheme musl" "--scheme usl --shape cpgimp" "--scheme usl --shape cpgimp --transfer fmpm" \
        "--scheme musl --shape cubic" "--scheme impm")"
atlas square "$large" "Manufactured square, displacements of 5 % of its side" e2 "relative error of the displacement, e2 [-]" 8,16,32,64 8,16 \
    "$(each "mms_square --G 0.05" "--scheme tlmpm" "--scheme tlmpm --shape cubic" "--scheme tlmpm --shape cubic --transfer fmpm --order 5 --points gauss" \
        "--scheme tlmpm --transfer apic" "--scheme musl" "--scheme usf" "--scheme usl --shape cpgimp" "--scheme impm")"
atlas vortex "$large" "Generalized vortex: a ring sheared to and fro" e2 "relative error of the displacement, e2 [-]" 30,60,120 30,60 \
    "$(each "vortex --points gauss --cfl 0.5" "--scheme tlmpm" "--scheme tlmpm --shape cubic" "--scheme tlmpm --shape bernstein --ppc 3" \
        "--scheme tlmpm --shape cubic --transfer fmpm --order 5" "--scheme musl" "--scheme usl --shape cpgimp")"
atlas cylinder "$pressed" "Thick cylinder under inner pressure (CPDI)" displacement "relative L2 error of the displacement [-]" 10,20,40 10,20 \
    "$(each cpdi_cylinder "--shape cpdi-q4" "--shape cpdi-t3" "--shape cpdi-polygon")"
atlas heat-bar "$heat" "Heated bar, temperature of the nodes" nodes "relative error of the temperature [-]" 10,20,40,80,160 10,20,40 \
    "$(each "heat_bar --ppc 2 --repeat 3" "" "--form printed" "--shape ugimp" "--shape cubic")"
atlas heat-plate "$heat" "Heated plate, temperature of the nodes" nodes "relative error of the temperature [-]" 10,20,40,80 10,20,40 \
    "$(each heat_plate "" "--form printed" "--shape cubic")"
atlas shock-tube "$fluids" "Shock tube of Sod, density at the nodes" rho_nodes "mean error of the density over that on the left [-]" 100,200,400,800 50,100,200 \
    "$(each "shock_tube --repeat 3" "--shape hat" "--shape cpgimp" "--shape cubic" "--shape cubic --c0 0 --c1 0")"
atlas channel "$fluids" "Couette flow, start-up" v_rms "error of the velocity over that of the wall [-]" 4,8,16,32 4,8,16 \
    "$(each channel "" "--shape cubic")"
atlas head-on-bars "$contact" "Two bars collide: duration of the contact" duration "relative error of the duration [-]" 50,100,200,400 25,50,100 \
    "$(each "head_on_bars --repeat 3" "--gap velocity" "--gap position" "--gap extent --normals regression")"
atlas sliding-block "$contact" "A block slides down a slope of 30 degrees, mu = 0.3" travel "relative error of the distance [-]" 5,10,20 5,10 \
    "$(each sliding_block "--normals gradient --common off --gap velocity" "--normals volume --gap velocity" "--normals volume --gap position" \
        "--normals regression --gap extent")"

[ -z "$only" ] || exit 0
printf '%s\n' $cases | xargs -P "$(nproc)" -n 1 "$0" "$build" "$figures" "$size"
"$build/gallery" --plots "$plots" --figures "$figures"
