#!/bin/sh
# links.sh PROGRAM...: no program links what only meshes and images need (CGAL's GMP and MPFR, libpng), and none holds a name of CGAL.
set -u
broken=0
for program; do
    links=$(ldd "$program") || exit 2
    found=$(echo "$links" | grep -E 'lib(CGAL|gmp|mpfr|png)')
    [ -z "$found" ] || { printf '%s links more than it needs:\n%s\n' "$program" "$found"; broken=1; }
    ! grep -qa N4CGAL "$program" || { echo "$program holds code of CGAL"; broken=1; }
done
exit $broken
