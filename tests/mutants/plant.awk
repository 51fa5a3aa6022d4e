# awk -v header=usl.hpp -f plant.awk table.txt usl.hpp: the header with all its mutants, each behind its number (its line in the table). A mutated
# line must be a whole statement: `x;` becomes `if (mutant == 7) { y; } else { x; }`, and `const T c = x;` a choice of its value.
function trim(text) { gsub(/^ +| +$/, "", text); return text }
# Whether the comment at the end of a line starts with this number.
function marked(line, mark,  at) {
    if (mark == "-") return 1
    at = index(line, "// " mark)
    return at > 0 && substr(line, at + 3 + length(mark), 1) !~ /[0-9-]/
}
function replaced(line, old, fresh,  at) {
    if (fresh == "-") return ";"
    at = index(line, old)
    return substr(line, 1, at - 1) fresh substr(line, at + length(old))
}
NR == FNR {
    if ($0 ~ /^#/ || split($0, column, "|") < 6 || trim(column[1]) != header) next
    mark[NR] = trim(column[2]); old[NR] = trim(column[3]); fresh[NR] = trim(column[4]); found[NR] = 0
    next
}
{
    statement = $0
    sub(/ *\/\/.*/, "", statement)
    constant = statement ~ /^ *const [A-Za-z0-9_<>]+ [A-Za-z0-9_]+ = /
    value = statement
    sub(/^[^=]*= /, "", value)
    choice = ""
    for (n in mark) {
        if (index(statement, old[n]) == 0 || !marked($0, mark[n])) continue
        ++found[n]
        if (constant) choice = choice "if (mutant == " n ") return " replaced(value, old[n], fresh[n]) " "
        else choice = choice "if (mutant == " n ") { " replaced(statement, old[n], fresh[n]) " } else "
    }
    if (choice == "") print
    else if (constant) { split(trim(statement), word, " "); print "const " word[2] " " word[3] " = [&]() -> " word[2] " { " choice "return " value " }();" }
    else print choice "{ " statement " }"
}
END {
    for (n in found)
        if (found[n] != 1) {
            print header ", table line " n ": '" old[n] "' in line " mark[n] " stands " found[n] " times, not once" > "/dev/stderr"
            lost = 1
        }
    exit lost
}
