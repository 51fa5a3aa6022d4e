/// stability: for each variant the largest stable time step as a fraction of the critical one, h/(c + |v|) or what the program names, and
/// how it fares in stiff cases.
///   ./stability -- usl_bar -- musl_bar --shape cubic
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "lab/figure.hpp"
#include "lab/program.hpp"
#include "plots/stability_figures.hpp"

namespace {

using namespace mpm;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Settings {
    Limits limits;
    std::string contrast = "1,1e2,1e4,1e6,1e8", out, label, plot = "png", programs;
    bool quick = false, quiet = false;

    void declare(Options& o) {
        o.integer("cells", limits.cells, "cells", between(3, 100000), "resolution, except of the fine grids");
        o.number("periods", limits.periods, "-", above(0), "length of the runs that find the largest step");
        o.number("tolerance", limits.tolerance, "-", between(1e-4, 1), "relative width at which the bisection ends");
        o.text("contrast", contrast, "ratios of stiffness between the halves of the bar");
        o.number("case-periods", limits.case_periods, "-", above(0), "length of the runs of the stiff cases; on fine grids it is 1");
        o.integer("finest", limits.finest, "cells", between(3, 1000000), "the fine grids have 256, 1024, 4096 cells, up to this");
        o.flag("quick", quick, "no contrast over 1e4, no grid over 256 cells");
        o.text("error", limits.error, "the error_name to show; empty: the first that a run reports");
        o.number("timeout", limits.timeout, "s", at_least(0), "a run that takes longer is killed and counts as failed; 0: none");
        o.text("programs", programs, "folder of the programs; empty: where this one is");
        o.text("out", out, "folder of the results; empty: out/stability/<label>");
        o.text("label", label, "name of the results; empty: made of the variants");
        o.choice("plot", plot, {"png", "svg", "pdf", "tikz", "none"}, "pictures to draw");
        o.flag("quiet", quiet, "say nothing but errors");
    }
    Words contrasts() const {
        Words values;
        for (std::size_t from = 0; from <= contrast.size();) {
            const std::size_t end = std::min(contrast.find(',', from), contrast.size());
            const std::string value = contrast.substr(from, end - from);
            char* rest = nullptr;
            const double number = std::strtod(value.c_str(), &rest);
            if (value.empty() || *rest != '\0' || !(number > 0) || !std::isfinite(number))
                throw BadInput("--contrast " + one_line(contrast) + ": numbers > 0 with commas between them are allowed");
            if (!quick || number <= 1e4) values.push_back(value);
            from = end + 1;
        }
        return values;
    }
};

/// Says on a terminal what is being run.
void say(const Settings& s, const std::string& what) {
    if (!s.quiet && isatty(STDERR_FILENO) == 1) std::fprintf(stderr, "\r%-80.80s\r", what.c_str());
}

void print(const std::vector<Case>& cases, const std::vector<Probed>& probed) {
    std::size_t width = 7;
    for (const Probed& p : probed) width = std::max(width, p.name.size());
    const int w = static_cast<int>(width);
    std::printf("largest stable time step, as a fraction of the critical one\n");
    for (const Probed& p : probed)
        std::printf("  %-*s  %s, of %s (%d runs)\n", w, p.name.c_str(), limit_text(p.limit).c_str(), p.unit.c_str(), p.limit.runs);
    for (std::size_t c = 0; c < cases.size(); ++c) {
        const bool none = std::all_of(probed.begin(), probed.end(), [&](const Probed& p) { return p.found[c].verdict == "left out"; });
        std::printf("%s, %d cells%s\n", cases[c].title.c_str(), cases[c].cells,
                    none ? (": left out, no program has " + joined(cases[c].needs, ", ")).c_str() : "");
        for (const Probed& p : probed) {
            const Found& f = p.found[c];
            if (!none) std::printf("  %-*s  %-18s  %s\n", w, p.name.c_str(), f.shown().c_str(), one_line(f.reason, 75).c_str());
        }
    }
}

int probe(const Settings& s, Programs& programs, const std::vector<Variant>& variants, const std::string& folder) {
    std::string shared;
    const Words names = short_names(variants, shared);
    const Words contrasts = s.contrasts();
    make_folder(folder);
    CsvFile csv(folder + "/stability.csv", {"program", "options", "case", "value", "cells", "periods", "dt", "fraction", "error_name",
                                            "error", "verdict", "t_fail", "reason"});
    std::vector<std::string> files{csv.path()};
    std::vector<Probed> probed;
    std::vector<Case> cases;
    bool failed = false;
    for (std::size_t v = 0; v < variants.size(); ++v) {
        const Variant& variant = variants[v];
        const auto row = [&](const std::string& name, const std::string& value, int cells, double periods, const Found& f) {
            csv.row({variant.program, variant.options(), name, value, std::to_string(cells), number_text(periods), number_text(f.dt),
                     number_text(f.fraction), f.error_name, number_text(f.error), f.verdict, number_text(f.t_fail), f.reason});
            failed = failed || f.verdict.starts_with("failed:");
        };
        Prober prober(programs, variant, s.limits, folder);
        say(s, names[v] + ": largest stable step");
        const auto limit = prober.largest_step();
        if (!limit) return 130;
        for (const auto& [name, trial] : {std::pair("largest-step", limit->stable), std::pair("step-beyond", limit->unstable)})
            if (trial)
                row(name, number_text(trial->fraction), s.limits.cells, s.limits.periods,
                    {s.limits.error, trial->verdict, trial->reason, trial->error, trial->fraction * prober.critical_dt(), trial->fraction,
                     nan});
        probed.push_back({names[v], *limit, {}, critical_name(programs, variant.program)});
        cases = stiff_cases(contrasts, s.limits, prober.particles_per_cell());
        for (const Case& stiff : cases) {
            say(s, names[v] + ": " + stiff.name + " " + stiff.value);
            const auto found = prober.run(stiff);
            if (!found) return 130;
            row(stiff.name, stiff.value, stiff.cells, stiff.periods, *found);
            probed.back().found.push_back(*found);
        }
    }
    say(s, "");
    if (!s.quiet) print(cases, probed);
    const std::string more = shared.empty() ? "" : ", " + one_line(shared, 40);
    std::vector<std::string> figures{
        write_step_figure(folder, "Largest stable time step, " + std::to_string(s.limits.cells) + " cells" + more, probed, files),
        write_case_map(folder, "Stiff cases: the error reached, or how it fails" + more, cases, probed, files)};
    for (const std::string& name : figures)
        if (!name.empty()) add_picture(folder, name, s.plot, files);
    if (!s.quiet) std::printf("%s", written(folder, files).c_str());
    return failed ? 3 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    return guarded("stability", [&] {
        const auto [own, given] = split_variants(argc, argv);
        Options options("stability",
                        "largest stable time step and stiff cases of each variant\n       stability [options] -- PROGRAM [its options] [-- "
                        "PROGRAM ...]...");
        Settings s;
        s.declare(options);
        std::vector<const char*> words;
        for (const std::string& word : own) words.push_back(word.c_str());
        options.parse(static_cast<int>(words.size()), words.data());
        if (answered(options, "stability")) return 0;
        catch_interrupts();
        if (s.quick) s.limits.finest = std::min(s.limits.finest, 256);
        if (given.empty()) throw BadInput("no variants: give at least one program after --, as in: stability -- usl_bar -- musl_bar");
        Programs programs(s.programs);
        std::vector<Variant> variants;
        Words labels;
        for (const Words& variant : given) {
            variants.push_back(programs.variant(variant, {"cells", "out", "label", "plot", "quiet", "dry-run", "help", "version",
                                                          "describe", "dt", "cfl", "periods", "t-end", "watch", "contrast", "offset"}));
            for (const char* option : {"cells", "dt"})
                if (!programs.accepts(variant.front(), option))
                    throw BadInput(variant.front() + " has no option --" + option + ", so its time step cannot be tried");
            programs.check_values(variants.back(), {"--cells", std::to_string(s.limits.cells)});
            if (std::find(labels.begin(), labels.end(), variants.back().file_name()) != labels.end())
                throw BadInput("the same variant is given twice: " + joined(variant, " "));
            labels.push_back(variants.back().file_name());
        }
        return probe(s, programs, variants,
                     run_folder("stability", options, s.out, s.label.empty() ? file_safe(joined(labels, "+"), 80) : s.label));
    });
}
