#!/bin/sh
# figures.sh BUILD FIGURES: runs the programs of the figures and draws every recipe of this folder.
set -eu
build=$(cd "$1" && pwd); plots=$(cd "$(dirname "$0")" && pwd); mkdir -p "$2"; figures=$(cd "$2" && pwd)
run() { name=$1; shift; echo "running $*"; program=$1; shift; "$build/$program" "$@" --quiet --out "$figures/data/$name"; }
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
export GNUPLOT_LIB="$plots"
for recipe in "$plots"/*.gp; do
    name=$(basename "$recipe" .gp)
    (cd "$figures" && gnuplot "$recipe") || { echo "gnuplot failed on $recipe" >&2; exit 1; }
    echo "drew $figures/$name.png"
done
