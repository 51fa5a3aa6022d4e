#!/bin/sh
# floors.sh ROOT: no include climbs a floor of the house (DESIGN.md section 1), and heavy headers stay behind a .cpp.
set -u
cd "$1" || exit 2
broken=0
# may FOLDER 'FLOOR|FLOOR' [MORE]: sources under FOLDER include (in quotes) only files of these floors.
may() {
    [ -d "$1" ] || return 0
    found=$(grep -rnE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' --include='*.hpp' --include='*.cpp' "$1" |
        grep -vE "#[[:space:]]*include[[:space:]]*\"($2)/")
    [ -z "$found" ] || { printf '%s may include only %s:\n%s\n' "$1" "$2" "$found"; broken=1; }
}
may lab 'lab'
may chapters 'lab|chapters'
may chapters/material 'lab|chapters/material'
may chapters/weighting 'lab|chapters/weighting'
may chapters/scenes 'lab|chapters/(material|scenes)'
may examples 'lab|chapters|examples'
may plots 'lab|plots'
may tests 'lab|chapters|examples|plots|tests'

heavy='CGAL/|boost/|gnuplot-iostream|png\.h'
found=$(grep -rnE "#[[:space:]]*include[[:space:]]*[<\"]($heavy)" --include='*.hpp' lab chapters plots)
[ -z "$found" ] || { printf 'heavy headers belong in a .cpp of lab:\n%s\n' "$found"; broken=1; }

# behind HEADER FILES: no other file includes it; a program that links it links its licence and its weight too.
behind() {
    found=$(grep -rlE "#[[:space:]]*include[[:space:]]*[<\"]$1" --include='*.hpp' --include='*.cpp' lab chapters examples plots tests | grep -vxE "$2")
    [ -z "$found" ] || { printf '%s belongs in %s only:\n%s\n' "$1" "$2" "$found"; broken=1; }
}
behind 'CGAL/' 'lab/(mesh|triangulate|voronoi_diagram)\.cpp'
behind 'png\.h' 'lab/image_png\.cpp'
exit $broken
