#!/bin/sh
# atlas.sh BUILD FIGURES [quick]: every case that has an exact or a reference solution, with the variants that can run it, at several resolutions: error
# against run time. The gallery makes a table of what each variant reached. What a sweep has finished is not run again.
set -eu
build=$(cd "$1" && pwd); mkdir -p "$2"; figures=$(cd "$2" && pwd); quick=${3:-}
# each 'words of all variants' 'words of one' 'words of another' ...: variants, as compare reads them.
each() { all=$1; shift; for words in "$@"; do printf ' -- %s %s' "$all" "$words"; done; }
# atlas NAME TITLE ERROR CELLS QUICK-CELLS VARIANTS
atlas() {
    folder=$figures/data/atlas-$1
    mkdir -p "$folder" && printf '%s\n%s\n' "$2" "$3" >"$folder/title"
    cells=$4; [ -z "$quick" ] || cells=$5
    echo "comparing $1 on $cells cells"
    # An unstable run or one that takes too long is a row of the table, and compare says 3.
    "$build/compare" --cells "$cells" --error "$3" --timeout 300 --quiet --out "$folder" $6 || [ $? -eq 3 ]
}

explicit=$(each "" "usl_bar" "usf_bar" "musl_bar" "tlmpm_bar" "musl_bar --shape cubic" "musl_bar --shape cpgimp" "tlmpm_bar --shape cubic" \
    "tlmpm_bar --shape bernstein --ppc 2" "tlmpm_bar --transfer apic" "tlmpm_bar --shape cubic --transfer fmpm --order 4" "impm_bar" "fem_bar" "cpdi_bar")
atlas bar "Axial vibration of a bar, mode 1, 10 periods" frequency 13,25,50,100,200 13,25,50 "$explicit"
atlas bar-implicit "The same bar, steps far beyond the explicit limit" frequency 13,25,50,100 13,25 \
    "$(each "" "musl_bar --cfl 0.5" "tlmpm_bar --cfl 0.5" "implicit_bar --cfl 0.5" "implicit_bar --cfl 5" "implicit_bar --cfl 50")"
atlas stiff-bar "A bar whose outer half is 1e4 times stiffer, one period" frequency 8,16,32,64 8,16 \
    "$(each "" "contrast_bar --scheme musl --contrast 1e4 --cfl 0.5" "contrast_bar --scheme tlmpm --contrast 1e4 --cfl 0.5" \
        "implicit_contrast_bar --contrast 1e4 --steps 50" "implicit_contrast_bar --contrast 1e4 --steps 200")"
atlas column "A column, loaded in a second" u_static 5,10,20,40 5,10 \
    "$(each "" "resting_column --scheme musl --ramp 1" "resting_column --scheme tlmpm --ramp 1" "implicit_column --ramp 1 --dt 0.1")"
swing="--rows 10 --layers 5 --g 0.01 --t-end 3 --reference 1.3464"
atlas cantilever "A short cantilever swings a little" frequency 8,16,32 8,16 \
    "$(each "" "cantilever --scheme musl $swing" "cantilever --scheme tlmpm $swing" "cantilever --scheme tlmpm --shape hat $swing" \
        "implicit_cantilever $swing")"
atlas segment "Manufactured segment, large displacements (G = 0.05)" e2 8,16,32,64,128,256 8,16,32,64 \
    "$(each "mms_segment --G 0.05 --ppc 2" "--scheme fem" "--scheme tlmpm" "--scheme tlmpm --shape cubic" "--scheme tlmpm --shape bernstein" \
        "--scheme tlmpm --transfer apic" "--scheme tlmpm --shape cubic --transfer consistent --points gauss" "--scheme usl" "--scheme usf" "--scheme musl" \
        "--scheme usl --shape cpgimp" "--scheme usl --shape cpgimp --transfer fmpm" "--scheme musl --shape cubic" "--scheme impm")"
atlas square "Manufactured square, large displacements (G = 0.05)" e2 8,16,32,64 8,16 \
    "$(each "mms_square --G 0.05" "--scheme tlmpm" "--scheme tlmpm --shape cubic" "--scheme tlmpm --shape cubic --transfer fmpm --order 5 --points gauss" \
        "--scheme tlmpm --transfer apic" "--scheme musl" "--scheme usf" "--scheme usl --shape cpgimp" "--scheme impm")"
atlas vortex "Generalized vortex" e2 30,60,120 30 \
    "$(each "vortex --points gauss --cfl 0.5" "--scheme tlmpm" "--scheme tlmpm --shape cubic" "--scheme tlmpm --shape bernstein --ppc 3" \
        "--scheme tlmpm --shape cubic --transfer fmpm --order 5" "--scheme musl" "--scheme usl --shape cpgimp")"
atlas cylinder "Thick cylinder under inner pressure (CPDI)" "" 10,20,40 10,20 "$(each cpdi_cylinder "--shape cpdi-q4" "--shape cpdi-t3" "--shape cpdi-polygon")"
atlas heat-bar "Heated bar, nodes" nodes 10,20,40,80,160 10,20,40 \
    "$(each "heat_bar --ppc 2" "" "--form printed" "--shape ugimp" "--shape cubic")"
atlas heat-plate "Heated plate, nodes" nodes 10,20,40,80 10,20 "$(each heat_plate "" "--form printed" "--shape cubic")"
atlas shock-tube "Shock tube of Sod, density at nodes (L1)" rho_nodes 100,200,400,800 50,100 \
    "$(each shock_tube "--shape hat" "--shape cpgimp" "--shape cubic" "--shape cubic --c0 0 --c1 0")"
atlas channel "Couette flow, start-up" v_rms 4,8,16,32 4,8,16 "$(each channel "" "--shape cubic")"
atlas head-on-bars "Two bars collide: duration of the contact" duration 50,100,200 25,50 \
    "$(each head_on_bars "--gap velocity" "--gap position" "--gap extent --normals regression")"
atlas sliding-block "A block slides down a slope, mu = 0.3, 30 degrees" travel 5,10,20 5 \
    "$(each sliding_block "--normals gradient --common off --gap velocity" "--normals volume --gap velocity" "--normals volume --gap position" \
        "--normals regression --gap extent")"
"$build/gallery" --plots "$(dirname "$0")" --figures "$figures"
