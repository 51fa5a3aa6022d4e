/// extremes: tables of stiff and extreme cases and of largest stable steps, each cell the error reached, the named instability, or why
/// there is none (plots/extremes.txt).
///   ./extremes --table plots/extremes.txt --quick
#include <cmath>
#include <cstdio>

#include "lab/figure.hpp"
#include "lab/program.hpp"
#include "plots/matrix_figure.hpp"

namespace {

using namespace mpm;

struct Settings {
    std::string table = "plots/extremes.txt", only, out = "out/extremes", plot = "png", programs;
    RunRules rules{1, 120, false};
    bool quick = false, quiet = false;

    void declare(Options& o) {
        o.text("table", table, "file of the tables");
        o.text("only", only, "names of the tables to make, with commas between them; empty: all");
        o.flag("quick", quick, "without the cases marked full");
        o.integer("jobs", rules.jobs, "-", between(1, 1000), "runs at a time");
        o.number("timeout", rules.timeout, "s", at_least(0), "a run that takes longer is killed and counts as failed; 0: none");
        o.flag("fresh", rules.fresh, "run again what has ended already");
        o.text("programs", programs, "folder of the programs; empty: where this one is");
        o.text("out", out, "folder of the results");
        o.choice("plot", plot, {"png", "svg", "pdf", "tikz", "none"}, "pictures to draw");
        o.flag("quiet", quiet, "say nothing but errors");
    }
    bool wants(const std::string& name) const { return only.empty() || ("," + only + ",").find("," + name + ",") != std::string::npos; }
};

void print(const CaseTable& table, const std::vector<ExtremeCase>& cases, const std::vector<std::vector<Cell>>& cells) {
    Footnotes notes;
    std::printf("%s\n%-32s", table.title.c_str(), "");
    for (const CaseColumn& column : table.columns) std::printf(" %-11.11s", column.name.c_str());
    std::printf("\n");
    for (std::size_t r = 0; r < cases.size(); ++r) {
        const bool first = r == 0 || cases[r].group != cases[r - 1].group;
        std::printf("%-20.20s %11.11s", first ? cases[r].group.c_str() : "", cases[r].value.c_str());
        for (const Cell& cell : cells[r]) {
            std::printf(" %-11.11s", (text_of(cell, notes) + (cell.kind == "inaccurate" ? "!" : "")).c_str());
        }
        std::printf("\n");
    }
    for (const std::string& reason : notes.reasons) std::printf("  %s: %s\n", notes.letter(reason).c_str(), one_line(reason, 200).c_str());
}

/// What the owner of a case must look into, one line each.
int print_defects(const std::vector<ExtremeCase>& cases, const CaseTable& table, const std::vector<std::vector<Cell>>& cells) {
    int defects = 0;
    for (std::size_t r = 0; r < cases.size(); ++r)
        for (std::size_t c = 0; c < cells[r].size(); ++c) {
            const Cell& cell = cells[r][c];
            if (!cell.defect()) continue;
            ++defects;
            std::printf("  %s %s, %s: %s %g, allowed %g (%s) %s\n", cases[r].group.c_str(), cases[r].value.c_str(),
                        table.columns[c].name.c_str(), cell.kind.c_str(), cell.error, cell.bound, cases[r].why.c_str(),
                        one_line(cell.reason, 120).c_str());
        }
    return defects;
}

int run(int argc, char** argv) {
    Options options("extremes", "tables of stiff and extreme cases and of largest stable steps");
    Settings s;
    s.declare(options);
    options.parse(argc, argv);
    if (answered(options, "extremes")) return 0;
    catch_interrupts();
    Programs programs(s.programs);
    make_folder(s.out);
    CsvFile csv(s.out + "/extremes.csv", {"table", "case", "value", "column", "command", "error_name", "error", "bound", "kind", "verdict",
                                         "reason", "why_of_bound", "seconds"});
    std::vector<std::string> files{csv.path()};
    int defects = 0;
    double seconds = 0;
    for (const CaseTable& table : read_case_tables(read_file(s.table), s.table)) {
        if (!s.wants(table.name)) continue;
        ExtremeRuns runs(programs, table, s.out, s.rules, s.quick);
        const auto cells = runs.all();
        if (!cells) return 130;
        const auto& cases = runs.cases();
        for (std::size_t r = 0; r < cases.size(); ++r)
            for (std::size_t c = 0; c < table.columns.size(); ++c) {
                const Cell& cell = (*cells)[r][c];
                std::string why_not;
                csv.row({table.name, cases[r].group, cases[r].value, table.columns[c].name,
                         joined(table.command(cases[r], table.columns[c], why_not), " "), cell.error_name, number_text(cell.error),
                         number_text(cell.bound), cell.kind, cell.verdict,
                         cell.known.empty() ? cell.reason : cell.known, cases[r].why, number_text(cell.seconds)});
                seconds += cell.seconds;
            }
        const std::string figure = write_matrix(s.out, table, cases, *cells, files);
        add_picture(s.out, figure, s.plot, files);
        if (!s.quiet) print(table, cases, *cells), defects += print_defects(cases, table, *cells);
        else
            for (const auto& row : *cells)
                for (const Cell& cell : row) defects += cell.defect();
    }
    if (!s.quiet) std::printf("%.0f s of CPU in the methods; %d cells to look into\n%s\n", seconds, defects, written(s.out, files).c_str());
    return defects > 0 ? 3 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    return guarded("extremes", [&] { return run(argc, argv); });
}
