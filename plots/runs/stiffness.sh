# Explicit beside implicit as the stiffness grows: `figures.sh BUILD FIGURES stiffness` makes implicit_stiffness.csv in FIGURES, some five minutes
# of CPU. A uniform bar, a bar with a stiffer half, a column that is loaded in a second, a cantilever with a stiffer end. Explicit runs that take
# more than a minute with all that is watched are estimated from those at a smaller stiffness: time grows with the steps, so with its root.
table=$figures/implicit_stiffness.csv
echo scene,stiffness,method,cells,error,seconds,measured >"$table"
# row SCENE STIFFNESS METHOD CELLS PROGRAM OPTIONS
row() {
    scene=$1 stiffness=$2 method=$3 cells=$4; shift 4; name=stiffness-$scene-$stiffness-$method-$cells
    run $name "$@" --cells $cells --records 10 || [ $? -eq 3 ]
    awk -F, -v first="$scene,$stiffness,$method,$cells" 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i }
        NR == 2 { printf "%s,%.3g,%.3g,1\n", first, $at["error"], $at["cpu_s"] }' "$figures/data/$name/summary.csv" >>"$table"
}
# estimate SCENE STIFFNESS METHOD CELLS OF FACTOR: the row of stiffness OF, taking FACTOR times as long
estimate() {
    awk -F, -v from="$1,$5,$3,$4," -v to="$1,$2,$3,$4" -v factor=$6 'index($0, from) == 1 { printf "%s,%s,%.3g,0\n", to, $5, factor * $6; exit }' \
        "$table" >"$table.new"
    cat "$table.new" >>"$table"; rm "$table.new"
}
for s in 1 10 100 1e3 1e4 1e6 1e8; do
    E=$(awk "BEGIN { print 100 * $s }")
    for n in 8 16 32; do
        row bar $s implicit $n implicit_contrast_bar --E $E --steps 50 --repeat 3
        row stiff-bar $s implicit $n implicit_contrast_bar --contrast $s --steps 50 --repeat 3
        for scheme in musl tlmpm; do
            row bar $s $scheme $n contrast_bar --scheme $scheme --E $E --cfl 0.5 --repeat 3
            case $s-$scheme-$n in
                1e8-*-32 | 1e8-tlmpm-16) estimate stiff-bar $s $scheme $n 1e6 10 ;;
                *) row stiff-bar $s $scheme $n contrast_bar --scheme $scheme --contrast $s --cfl 0.5 ;;
            esac
        done
    done
    row column $s implicit 10 implicit_column --stiffer $s --ramp 1 --dt 0.1
    for scheme in musl tlmpm; do
        if [ $s = 1e8 ]; then estimate column $s $scheme 10 1e6 10
        else row column $s $scheme 10 resting_column --scheme $scheme --stiffer $s --ramp 1; fi
    done
done
# Frequencies by TLMPM with 5,383 particles and cubic splines on 64 cells, beyond a contrast of 100 that of 100.
beam="--rows 10 --layers 5 --g 0.01 --t-end 3 --reference"
for pair in 1:1.3464 10:1.3777 100:1.3836 1e3:1.3836 1e4:1.3836 1e6:1.3836; do
    s=${pair%:*} f=${pair#*:}
    for n in 8 16; do row cantilever $s implicit $n implicit_cantilever --contrast $s $beam $f; done
    case $s in
        1e6) estimate cantilever $s tlmpm-cubic 16 1e4 10 ;;
        *) row cantilever $s tlmpm-cubic 16 cantilever --contrast $s $beam $f ;;
    esac
    case $s in 1e4 | 1e6) continue ;; esac
    for n in 16 32; do row cantilever $s tlmpm-hat $n cantilever --shape hat --contrast $s $beam $f; done
done
