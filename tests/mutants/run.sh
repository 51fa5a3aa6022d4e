#!/bin/sh
# run.sh [JOBS [FOLDER]]: breaks one line of a scheme at a time (table.txt) and demands that the named test notices. All mutants of all schemes are
# compiled together (plant.awk), each test file once; MUTANT=number chooses the one that runs.
set -u
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
jobs=${1:-2} work=${2:-$root/build/mutants}
table=$here/table.txt
compile="${CXX:-g++} -std=c++20 -O1 -isystem ${EIGEN:-/usr/include/eigen3}"

# column N: that column of every mutant, without spaces.
column() { grep '^[^#].*|' "$table" | awk -F'|' -v n="$1" '{ gsub(/ /, "", $n); print $n }' | sort -u; }

rm -rf "$work"
mkdir -p "$work/chapters/explicit"
for header in $(column 1); do
    awk -v header="$header" -f "$here/plant.awk" "$table" "$root/chapters/explicit/$header" >"$work/chapters/explicit/$header" || exit 1
done
cp "$here/heavy.hpp" "$work/"
$compile -x c++-header "$work/heavy.hpp" -o "$work/heavy.hpp.gch" || exit 1
column 5 | xargs -P "$jobs" -I TEST $compile -include "$work/heavy.hpp" -I "$work" -I "$root" "$root/tests/chapters/explicit/TEST.cpp" \
    "$root/lab/memory.cpp" "$root/lab/strips.cpp" "$root/lab/threads.cpp" -lgtest_main -lgtest -pthread -o "$work/TEST" || exit 1

mutants=0 alive=0
while IFS='|' read -r number header line old new test name; do
    mutants=$((mutants + 1)) name=$(echo "$name" | tr -d ' ') program=$work/$(echo "$test" | tr -d ' ')
    what="table line $number: $header, line $line: '$old' -> '$new', $name"
    if ! "$program" --gtest_filter="$name" 2>&1 | grep -q '^\[  PASSED  \] 1 test\.'; then
        echo "NOT GREEN without a mutant: $what"
    elif MUTANT=$number timeout 60 "$program" --gtest_filter="$name" >"$work/log" 2>&1; then
        echo "SURVIVES: $what"
    else
        continue
    fi
    alive=$((alive + 1))
done <<END
$(grep -n '^[^#].*|' "$table" | sed 's/:/|/; s/ *| */|/g')
END
echo "$((mutants - alive)) of $mutants mutants of the schemes are noticed"
[ "$alive" = 0 ]
