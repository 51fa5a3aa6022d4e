/// cell_crossing: two bodies meet and rebound (review 3.2, figures 12 to 14) by USL (usl.hpp), with hat functions and with every smooth
/// one: what crossing the edge of a cell does to strain rate, force and energy.
///   ./cell_crossing --ppc 3 --offset 0.05 --plot png
/// The smaller the mass of a node that a hat-function particle has just reached, the larger the jump; a step that ends on the node but for
/// rounding (as with --cells 5 --cfl 0.01) blows the strain energy up.
#include "chapters/explicit/cell_crossing.hpp"

#include <cstdio>

#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/usl.hpp"
#include "chapters/weighting/assemble_with.hpp"

using namespace mpm;
using crossing::Run;
using crossing::Settings;

namespace {

constexpr const char* program = "cell_crossing";
constexpr const char* purpose = "two bodies meet: what crossing cells does, for each weighting function";

Assembled assembled(const std::string& shape, const Settings& set) {
    Assembled a;
    Common common;
    common.ppc = set.ppc;
    common.t_end = set.scene.t_end;
    UpdatedShapes::with(shape, [&](auto kernel) {
        a = assemble_with<decltype(kernel), false>(Usl{}, set.scene, Flip{}, set.scene.cells, common);
    });
    return a;
}

Run run_shape(const std::string& shape, Settings set, const std::string& folder, const Options& options) {
    set.scene.meter = std::make_shared<CrossingMeter>();
    Assembled a = assembled(shape, set);
    make_folder(folder);
    const RunPlan plan = plan_of(set, a, folder);
    Run run;
    run.result = mpm::run(a.simulation, plan);
    run.row = a.row;
    run.row.program = program;
    run.row.options = options.changed();
    run.errors = a.errors(plan.t_end);
    run.crossings = set.scene.meter->crossings;
    finish(run, plan);
    return run;
}

void declare(Options& o, Settings& set) {
    std::vector<std::string> shapes = UpdatedShapes::names();
    shapes.push_back("all");
    o.choice("shape", set.shape, shapes, "weighting function");
    set.scene.declare(o);
    o.integer("ppc", set.ppc, "-", between(1, 100), "particles per body, which is one cell long");
    o.number("cfl", set.cfl, "-", above(0), "time step as a fraction of h/(c + |v|)");
    o.number("dt", set.dt, "time", at_least(0), "time step; 0: from --cfl");
    o.contradict("dt", "cfl");
    o.integer("records", set.records, "rows", between(1, 100000000), "rows of the histories");
    o.choice("watch", set.watch, {"stop", "warn"}, "stop when unstable, or go on and say so at the end");
    set.declare(o);
    o.unlabelled("records");
}

void report(const std::vector<Run>& runs, const std::vector<std::string>& files) {
    const SummaryRow& row = runs.front().row;
    std::printf("%s: %s\n", program, TwoBodies::solves);
    std::printf("%s, %s: %d cells, h = %.4g, %ld particles, dt = %.4g (%.3g of h/(c + |v|))\n", row.scheme.c_str(), row.transfer.c_str(),
                row.cells, row.h, row.particles, row.dt, row.cfl);
    std::printf("           cells    largest jump in a step of    strain energy  rebound speed       energy     momentum\n");
    std::printf("shape      crossed  strain rate  acceleration  left            missing             drift        drift  verdict\n");
    std::printf("                    [v0/h]       [c v0/h]      [K0]            [v0]\n");
    for (const Run& run : runs) {
        std::printf("%-10s %7d", run.row.shape.c_str(), run.crossings);
        for (const NamedError& e : run.errors) std::printf("  %12.3e", e.value);
        std::printf("  %12.2e %12.2e  %s\n", run.row.energy_drift, run.row.momentum_drift, run.row.verdict.c_str());
        if (run.result.trouble) std::printf("  UNSTABLE at t = %.6g: %s\n", run.result.t_fail, run.result.trouble.reason.c_str());
        if (run.result.interrupted) std::printf("  INTERRUPTED at t = %.6g; the last state is written\n", run.result.t);
    }
    say_written(files);
}

int run_all(int argc, char** argv) {
    Options options(program, purpose);
    Settings set;
    declare(options, set);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;

    const std::string folder = run_folder(program, options, set.out, set.label);
    const std::vector<std::string> wanted = set.shape == "all" ? UpdatedShapes::names() : std::vector{set.shape};
    for (const std::string& shape : wanted) plan_of(set, assembled(shape, set), folder);  // refuses before anything is written
    catch_interrupts();
    make_folder(folder);
    write_file(folder + "/run.ini", options.ini());
    std::vector<Run> runs;
    std::vector<std::string> shapes,
        files{folder + "/run.ini", folder + "/summary.csv", folder + "/cell_crossing.csv", folder + "/cell_crossing.gp"};
    bool unstable = false;
    for (const std::string& shape : wanted) {
        runs.push_back(run_shape(shape, set, crossing::folder_of(folder, shape, set), options));
        shapes.push_back(shape);
        const RunResult& result = runs.back().result;
        files.insert(files.end(), result.files.begin(), result.files.end());
        unstable = unstable || result.trouble;
        if (result.interrupted) break;
    }
    crossing::write_summary(folder + "/summary.csv", runs);
    crossing::write_together(folder, shapes, set);
    crossing::write_figures(folder, shapes, set);
    add_picture(folder, program, set.plot, files);
    if (!set.quiet) report(runs, files);
    return runs.back().result.interrupted ? 130 : unstable ? 3 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run_all(argc, argv); });
}
