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
printf '%s\n' vortex contact disks fluid square implicit coupling cpdi segment improved locking thermal explicit filling weighting |
    xargs -P "$(nproc)" -n 1 "$0" "$build" "$figures"
for name in column compared extremes; do "$0" "$build" "$figures" $name; done

# Recipes go with the figures, so that each can be drawn again there.
cp "$plots"/*.gp "$plots"/*.csv "$plots"/style.gnuplot "$figures"
for recipe in "$plots"/*.gp; do
    name=$(basename "$recipe" .gp)
    (cd "$figures" && gnuplot "$name.gp") || { echo "gnuplot failed on $recipe" >&2; exit 1; }
    echo "drew $name in $figures"
done
"$build/gallery" --plots "$plots" --figures "$figures"
