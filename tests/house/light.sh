#!/bin/sh
# light.sh PROGRAM SOURCE COMPILE...: the program links neither CGAL nor GMP nor libpng, and its source sees no heavy header.
set -u
program=$1 source=$2
shift 2
links=$(ldd "$program") || exit 2
headers=$("$@" -M "$source") || exit 2
echo "$headers" | grep -q 'lab/program.hpp' || { echo "no headers listed for $source"; exit 2; }
found=$(echo "$links" | grep -E 'lib(CGAL|gmp|mpfr|png)'; echo "$headers" | tr ' ' '\n' | grep -E '/(CGAL|boost)/|/(gmp|gmpxx|mpfr|png|gnuplot-iostream)\.h')
[ -z "$found" ] || { printf '%s is not light:\n%s\n' "$program" "$found"; exit 1; }
