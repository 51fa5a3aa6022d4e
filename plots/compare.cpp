/// compare: variants side by side, each at several resolutions: error against run time, error against cell size, histories.
///   ./compare --cells 25,50,100 -- usl_bar --mode 1 -- musl_bar --mode 1 --shape cubic
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "lab/figure.hpp"
#include "lab/program.hpp"
#include "plots/compare_figures.hpp"

namespace {

using namespace mpm;

struct Settings {
    std::vector<int> cells{25, 50, 100};
    std::string error, error_label, title, clock = "wall", history, out, label, plot = "png", programs, collect;
    int history_cells = 0, jobs = 1;
    double timeout = 0;
    bool fresh = false, list = false, quiet = false;

    void declare(Options& o) {
        o.integers("cells", cells, "cells", between(1, 1000000), "resolutions at which each variant is run");
        o.text("error", error, "the error_name to look at; empty: the first that a run reports");
        o.text("error-label", error_label, "what the error is and its unit, for the figures; empty: its name");
        o.text("title", title, "of the figures; empty: the scene and the options that all variants share");
        o.choice("clock", clock, {"wall", "cpu"}, "seconds of the method by the clock on the wall or of the processor");
        o.text("history", history, "column of history.csv to draw of each variant, e.g. v_cm");
        o.integer("history-cells", history_cells, "cells", between(0, 1000000),
                  "resolution of these histories; 0: the finest of each variant");
        o.integer("jobs", jobs, "-", between(1, 1024), "runs at a time; more than one disturbs the measured times");
        o.number("timeout", timeout, "s", at_least(0), "a run that takes longer is killed and counts as failed; 0: none");
        o.flag("fresh", fresh, "run again what an earlier sweep has finished");
        o.flag("list", list, "print the commands one a line instead of running them, for GNU parallel");
        o.text("collect", collect, "folder of a listed sweep: stack and draw what its commands wrote");
        o.text("programs", programs, "folder of the programs; empty: where this one is");
        o.text("out", out, "folder of the comparison; empty: out/compare/<label>");
        o.text("label", label, "name of the comparison; empty: made of its variants");
        o.choice("plot", plot, {"png", "svg", "pdf", "tikz", "none"}, "pictures to draw");
        o.flag("quiet", quiet, "say nothing but errors");
        for (const char* other : {"cells", "fresh", "list", "jobs", "timeout", "out", "label", "programs"}) o.contradict("collect", other);
    }
};

/// out/compare/<label>, the label made of the variants.
std::string folder_of(const Settings& s, const Options& options, const std::vector<Variant>& variants) {
    Words names;
    for (const Variant& v : variants) names.push_back(v.file_name());
    return run_folder("compare", options, s.out, s.label.empty() ? file_safe(joined(names, "+"), 80) : s.label);
}

/// The error that --error names, or the first there is.
std::string chosen_error(const Settings& s, const std::vector<StackedRow>& rows) {
    const std::vector<std::string> names = error_names(rows);
    if (s.error.empty()) return names.empty() ? "error" : names.front();
    if (names.empty() || std::find(names.begin(), names.end(), s.error) != names.end()) return s.error;
    throw BadInput("--error " + one_line(s.error) + ": the runs report " + joined(names, ", "));
}

/// Figures, tables and the list of files, from what stands on the disk.
void show(const Settings& s, const std::string& folder, const std::vector<Run>& runs, const std::vector<StackedRow>& rows) {
    std::vector<std::string> files{folder + "/compare.csv"};
    Words scenes;
    for (const StackedRow& r : rows)
        if (!r.row.scene.empty() && std::find(scenes.begin(), scenes.end(), r.row.scene) == scenes.end()) scenes.push_back(r.row.scene);
    Subject subject{folder, chosen_error(s, rows), joined(scenes, ", "), runs.front().shared, {}, s.title, s.error_label,
                    s.clock == "cpu"};
    subject.series = series(runs, rows, subject.error, subject.cpu);
    if (!s.quiet) std::printf("%s%s", comparison_table(subject.series, subject.error).c_str(), reached_lines(subject.series).c_str());
    std::vector<std::string> names = write_error_figures(subject, files);
    if (!s.history.empty()) names.push_back(write_history_figure(subject, s.history, s.history_cells, files));
    for (const std::string& name : names) add_picture(folder, name, s.plot, files);
    if (!s.quiet) std::printf("%s", written(folder, files).c_str());
}

int collect(const Settings& s) {
    const std::vector<Run> runs = read_sweep(s.collect);
    if (runs.empty()) throw FileTrouble(s.collect + "/sweep.csv lists no runs");
    const std::vector<StackedRow> rows = stack(s.collect, runs, true);
    write_stack(s.collect + "/compare.csv", rows);
    show(s, s.collect, runs, rows);
    return all_well(rows) ? 0 : 3;
}

int list(const Settings& s, const std::string& folder, const std::vector<Run>& runs) {
    const std::vector<std::string> lines = list_sweep(folder, runs, s.fresh);
    for (const std::string& line : lines) std::printf("%s\n", line.c_str());
    if (lines.size() < runs.size() && !s.quiet)
        std::fprintf(stderr, "%zu of %zu runs have ended already; --fresh lists them again\n", runs.size() - lines.size(), runs.size());
    return 0;
}

int sweep(const Settings& s, const std::string& folder, const std::vector<Run>& runs) {
    const auto kept = s.fresh ? 0 : std::count_if(runs.begin(), runs.end(), [&](const Run& run) { return is_complete(folder, run); });
    if (!s.quiet && kept > 0)
        std::printf("%ld of %zu runs are taken from an earlier sweep; --fresh runs them again\n", static_cast<long>(kept), runs.size());
    const auto refresh = [&] {
        const std::vector<StackedRow> rows = stack(folder, runs, false);
        write_stack(folder + "/compare.csv", rows);
        return rows;
    };
    const bool whole = run_sweep(folder, runs, {s.jobs, s.timeout, s.fresh}, [&](const Run&) { chosen_error(s, refresh()); });
    const std::vector<StackedRow> rows = refresh();
    if (!whole) {
        std::fprintf(stderr, "interrupted: %s/compare.csv has the rows so far; the same command goes on from there\n", folder.c_str());
        return 130;
    }
    show(s, folder, runs, rows);
    return all_well(rows) ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
    return guarded("compare", [&] {
        const auto [own, variants] = split_variants(argc, argv);
        Options options(
            "compare",
            "variants side by side, each at several resolutions\n       compare [options] -- PROGRAM [its options] [-- PROGRAM ...]...");
        Settings s;
        s.declare(options);
        std::vector<const char*> words;
        for (const std::string& word : own) words.push_back(word.c_str());
        options.parse(static_cast<int>(words.size()), words.data());
        if (answered(options, "compare")) return 0;
        catch_interrupts();
        if (!s.collect.empty()) {
            if (!variants.empty()) throw BadInput("--collect takes no variants: the folder knows them");
            return collect(s);
        }
        if (variants.empty()) throw BadInput("no variants: give at least one program after --, as in: compare -- usl_bar -- musl_bar");
        Programs programs(s.programs);
        std::vector<Variant> checked;
        Words cells;
        for (const int n : s.cells) cells.push_back(std::to_string(n));
        for (const Words& variant : variants) {
            checked.push_back(
                programs.variant(variant, {"cells", "out", "label", "plot", "quiet", "dry-run", "help", "version", "describe"}));
            if (programs.accepts(variant.front(), "cells")) programs.check_values(checked.back(), {"--cells", joined(cells, ",")});
        }
        const std::string folder = folder_of(s, options, checked);
        const std::vector<Run> runs = plan_sweep(programs, checked, s.cells, folder);
        make_folder(folder);
        write_sweep(folder, runs);
        return s.list ? list(s, folder, runs) : sweep(s, folder, runs);
    });
}
