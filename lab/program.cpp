#include "lab/program.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <new>
#include <stdexcept>
#include <system_error>

#include "lab/program_figures.hpp"
#include "lab/study.hpp"

#ifndef MPM_LAB_VERSION
#define MPM_LAB_VERSION "0.1"
#endif

namespace mpm {
namespace {

namespace fs = std::filesystem;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

RunPlan plan_of(const Common& c, const Assembled& a, const std::string& folder, const std::vector<std::string>& columns) {
    RunPlan plan = whole_steps(c.t_end, c.dt > 0 ? c.dt : c.cfl * a.critical_dt, a.critical_dt);
    plan.dim = a.row.dim;
    plan.limit = c.limit;
    plan.cfl = c.dt_from == "step" ? c.cfl : 0;
    plan.progress = !c.quiet;
    plan.records = c.records;
    plan.frames = c.frames;
    plan.nodes = {c.format == "csv", c.format == "vtk"};
    plan.particles = {c.format == "csv" || shows_particles(c, a), c.format == "vtk"};  // pictures are drawn from CSV
    plan.stop_on_trouble = c.watch == "stop";
    plan.folder = folder;
    plan.columns = columns;
    return plan;
}

/// How much longer a step takes by a transfer that maps to the grid and back `order` times (XPIC, FMPM): a third for each.
double repeated_mapping(const Options& options) {
    static const std::string name = "order=";
    const std::string changed = options.changed();
    const std::size_t at = changed.find(name);
    return at == std::string::npos ? 1 : 1 + std::atof(changed.c_str() + at + name.size()) / 3;
}

/// Events that are legal but should be rare are counted and said.
void rare_events(const NodeWatch& nodes) {
    if (nodes.tiny_nodes > 0)
        std::printf("  %-36s %12.3e of a particle's; below %.0e at %ld node steps\n", "smallest nodal mass", nodes.smallest,
                    NodeWatch::tiny, nodes.tiny_nodes);
    if (nodes.cut_nodes > 0)
        std::printf("  %-36s %12ld node steps, their momentum is lost\n", "left out by the mass cut-off", nodes.cut_nodes);
}

void report(const Assembled& a, const RunResult& r, const RunPlan& plan, double t_end) {
    std::printf("%s, %s, %s: %d cells, h = %.4g, %ld particles, dt = %.4g (%.3g of %s), %ld steps\n", a.row.scheme.c_str(),
                a.row.shape.c_str(), a.row.transfer.c_str(), a.row.cells, a.row.h, a.row.particles, plan.dt, plan.dt / plan.critical_dt,
                plan.limit.c_str(), r.steps);
    if (!r.stopped)
        for (const auto& [name, value] : a.facts(t_end)) std::printf("  %-36s %12.5g\n", name.c_str(), value);
    std::printf("  %-36s %12.3e\n  %-36s %12.3e\n", "energy drift / energy in play", r.energy_drift, "momentum unaccounted for / sum m|v|",
                r.momentum_drift);
    rare_events(a.nodes());
    std::printf("  %-36s %9.3f s wall, %.3f s CPU, %.1f ns per particle step\n", "run time of the method", r.wall, r.cpu,
                1e9 * r.wall / static_cast<double>(std::max(1L, r.steps)) / static_cast<double>(a.row.particles));
    std::printf("  %-36s %ld B per particle, %ld B per node, peak %ld kB\n", "memory", a.row.bytes_per_particle, a.row.bytes_per_node,
                peak_memory_kb());
    if (r.trouble) std::printf("  UNSTABLE at t = %.6g: %s: %s\n", r.t_fail, r.trouble.cause.c_str(), r.trouble.reason.c_str());
    if (r.interrupted) std::printf("  INTERRUPTED at t = %.6g; the last state is written\n", r.t);
}

}  // namespace

void Common::declare(Options& o, const std::vector<std::string>& shapes, double default_t_end,
                     const SceneTraits& traits) {
    t_end = default_t_end;
    limit = traits.limit;
    o.integers("cells", cells, "cells", between(3, 1000000), "cells across the body's longest side; a list runs each");
    o.integer("ppc", ppc, "-", between(1, 100), "particles per cell and direction");
    o.choice("shape", shape, shapes, "weighting function");
    o.number("cfl", cfl, limit, above(0), "time step as a fraction of " + limit);
    o.number("dt", dt, "time", at_least(0), "time step; 0: from --cfl");
    o.contradict("dt", "cfl");
    o.choice("dt-from", dt_from, {"start", "step"}, "whole equal steps, or " + limit + " afresh every step (review 2.7)");
    o.contradict("dt", "dt-from");
    o.number("t-end", t_end, "time", above(0), "end of the run");
    if (traits.period) {
        o.number("periods", periods, "-", at_least(0), "end of the run in periods; 0: from --t-end");
        o.contradict("periods", "t-end");
    }
    o.text("out", out, "folder of the run; empty: out/<program>/<label>");
    o.text("label", label, "name of the run; empty: made of the options that differ");
    o.integer("records", records, "rows", between(1, 100000000), "rows of history.csv");
    const bool plane = !traits.colours.empty();
    o.integer("frames", frames, "-", between(0, 100000),
              std::string("snapshots of particles and nodes after the start's; unless told, --plot gif takes 50") +
                  (plane ? " and any other picture 3" : ""));
    o.choice("format", format, {"csv", "vtk"}, "files of snapshots; with vtk (ParaView) CSV only if a picture of particles is drawn from it");
    o.flag("smooth", smooth, "snapshots also hold the stress smoothed through the grid (review 4.10)");
    o.choice("plot", plot, {"none", "png", "svg", "pdf", "tikz", "gif"},
             plane ? "pictures to draw: history and particles; gif: an animation of the snapshots"
                   : "picture to draw; gif: an animation of the snapshots");
    if (plane) {
        colour = traits.colour;
        o.choice("colour", colour, traits.colours, "what the colours of particles show; ..._smooth with --smooth");
        o.unlabelled("colour");
    }
    o.integer("repeat", repeat, "-", between(1, 1000), "runs of each resolution; the fastest is reported");
    o.choice("watch", watch, {"stop", "warn"}, "stop when unstable, or go on and say so at the end");
    o.flag("quiet", quiet, "say nothing but errors");
    o.flag("dry-run", dry_run, "print what would run, run nothing");
    for (const char* name : {"out", "label", "plot", "quiet", "dry-run", "records", "frames", "format", "smooth", "repeat"})
        o.unlabelled(name);
}

void Common::declare_threads(Options& o) {
    o.integer("threads", threads, "-", between(1, 256), "threads that share a step; the results are the same to rounding");
}

std::string run_folder(const std::string& program, const Options& options, const std::string& out, const std::string& label) {
    const std::string name = label.empty() ? options.label() : label;
    if (name.find('/') != std::string::npos || name == "." || name == "..")
        throw BadInput("--label " + name + ": the name of a folder is allowed");
    return out.empty() ? "out/" + program + "/" + name : out;
}

void make_folder(const std::string& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error || !fs::is_directory(path)) throw FileTrouble("cannot make the folder " + path + ": " + error.message());
}

RunPlan whole_steps(double t_end, double wanted, double critical_dt) {
    const double steps = std::ceil(t_end / wanted * (1 - 1e-12));
    if (!(steps < 1e10))
        throw BadInput("--t-end or --dt, --cfl: the time step " + number_text(wanted) + " needs more than 1e10 steps to reach " +
                       number_text(t_end));
    RunPlan plan;
    plan.t_end = t_end;
    plan.steps = std::max(1L, static_cast<long>(steps));
    plan.dt = t_end / static_cast<double>(plan.steps);
    plan.critical_dt = critical_dt;
    return plan;
}

void add_result(SummaryRow& row, const RunPlan& plan, const RunResult& r) {
    row.dt = plan.dt;
    row.cfl = plan.dt / plan.critical_dt;
    row.steps = r.steps;
    row.t_end = plan.t_end;
    row.energy_drift = r.energy_drift;
    row.momentum_drift = r.momentum_drift;
    row.wall_s = r.wall;
    row.cpu_s = r.cpu;
    row.ns_per_particle_step = 1e9 * r.wall / static_cast<double>(std::max(1L, r.steps)) / static_cast<double>(row.particles);
    row.peak_rss_kb = peak_memory_kb();
    row.verdict = r.trouble ? "unstable:" + r.trouble.cause : r.interrupted ? "interrupted" : "ok";
    row.t_fail = r.trouble ? r.t_fail : nan;
    row.reason = r.trouble.reason;
}

bool answered(const Options& options, const std::string& program) {
    if (options.asked("help"))
        std::fputs(options.help().c_str(), stdout);
    else if (options.asked("version"))
        std::printf("%s, MPM Lab %s\n", program.c_str(), MPM_LAB_VERSION);
    else if (options.asked("describe"))
        std::fputs(options.describe().c_str(), stdout);
    else
        return false;
    return true;
}

static int too_large(const std::string& program) {
    std::fprintf(stderr, "%s: --cells, --ppc: the grid or the particles do not fit into memory\n", program.c_str());
    return 2;
}

int guarded(const std::string& program, const std::function<int()>& main_body) {
    try {
        return main_body();
    } catch (const BadInput& bad) {
        std::fprintf(stderr, "%s: %s\n", program.c_str(), bad.what());
        return 2;
    } catch (const FileTrouble& bad) {
        std::fprintf(stderr, "%s: %s\n", program.c_str(), bad.what());
        return 1;
    } catch (const OutsideGrid& outside) {  // before the first step: the scene puts a particle there
        std::fprintf(stderr, "%s: a particle starts outside the grid: %s\n", program.c_str(), outside.what());
        return 2;
    } catch (const std::bad_alloc&) {
        return too_large(program);
    } catch (const std::length_error&) {
        return too_large(program);
    }
}

Common Common::with_period(double period) const {
    Common c = *this;
    if (c.periods > 0) c.t_end = c.periods * period;
    return c;
}

namespace {

/// One program's run over all resolutions: what every resolution adds to.
struct Report {
    const Description& about;
    const Options& options;
    Common c;
    const std::function<Assembled(int)>& assemble;
    std::string folder = run_folder(about.program, options, c.out, c.label);
    std::vector<SummaryRow> rows{}, headline{};
    std::vector<std::string> files{};
    bool unstable = false;

    /// Looks at every resolution, so that nothing is run if one cannot be.
    void dry_run(bool say) const {
        for (const int cells : c.cells) {
            const Assembled a = assemble(cells);
            const RunPlan plan = plan_of(c, a, folder, about.columns);
            if (!say) continue;
            const double particle_steps =
                static_cast<double>(plan.steps) * static_cast<double>(a.row.particles) * repeated_mapping(options);
            std::printf(
                "%d cells: %s = %.4g; dt = %.4g, %ld steps, %ld particles, about %.2g MB and %.2g s\n", cells,
                c.limit.c_str(), a.critical_dt, plan.dt, plan.steps, a.row.particles,
                5 + 2e-6 * static_cast<double>(a.row.particles * a.row.bytes_per_particle), 5e-8 * a.row.dim * particle_steps);
        }
    }

    /// Runs one resolution, the fastest of --repeat, and writes what belongs to it. Returns whether it was interrupted.
    bool resolution(int cells, CsvFile& summary) {
        const std::string here = c.cells.size() > 1 ? folder + "/cells-" + std::to_string(cells) : folder;
        make_folder(here);
        RunResult best;
        Assembled a;
        RunPlan plan;
        for (int i = 0; i < c.repeat; ++i) {
            Assembled fresh = assemble(cells);
            plan = plan_of(c, fresh, here, about.columns);
            RunResult r = run(fresh.simulation, plan);
            if (i == 0 || r.interrupted || r.wall < best.wall) best = r;
            a = std::move(fresh);
            if (r.interrupted) break;
        }
        unstable = unstable || best.trouble;
        summarise(a, plan, best, summary);
        files.insert(files.end(), best.files.begin(), best.files.end());
        history_figure(about, c, a, best, here, files);
        particle_figures(about, c, a, best, here, files);
        if (!c.quiet) report(a, best, plan, c.t_end);
        return best.interrupted;
    }

    void summarise(const Assembled& a, const RunPlan& plan, const RunResult& r, CsvFile& summary) {
        SummaryRow row = a.row;
        row.program = about.program;
        row.options = options.changed();
        add_result(row, plan, r);
        const std::size_t first = rows.size();
        for (const NamedError& e : a.errors(c.t_end)) {
            row.error_name = e.name;
            row.error = r.stopped ? nan : e.value;
            rows.push_back(row);
        }
        fill_orders(rows);
        headline.push_back(rows[first]);
        for (std::size_t i = first; i < rows.size(); ++i) summary.row(summary_fields(rows[i]));
    }

    int all() {
        dry_run(false);
        if (!c.quiet) std::printf("%s: %s\n", about.program.c_str(), about.solves.c_str());
        make_folder(folder);
        write_file(folder + "/run.ini", "# MPM Lab " MPM_LAB_VERSION "\n" + options.ini());
        CsvFile summary(folder + "/summary.csv", summary_columns());
        files = {folder + "/run.ini", summary.path()};
        for (const int cells : c.cells)
            if (resolution(cells, summary)) return 130;
        if (!c.quiet) {
            if (c.cells.size() > 1) std::fputs(error_table(headline).c_str(), stdout);
            say_written(files);
        }
        return unstable ? 3 : 0;
    }
};

}  // namespace

int run_program(const Description& about, const Options& options, const Common& common, const std::function<Assembled(int)>& assemble) {
    catch_interrupts();
    Common c = common;
    if (c.plot == "gif" && c.frames == 0) c.frames = 50;
    const bool plane = !c.colour.empty();
    if (plane && c.plot != "none" && !options.given("frames") && c.frames == 0) c.frames = 3;
    if (c.colour.ends_with("_smooth") && !c.smooth) throw BadInput("--colour " + c.colour + ": allowed with --smooth");
    Report report{about, options, c, assemble};
    if (!c.dry_run) return report.all();
    report.dry_run(true);
    return 0;
}

}  // namespace mpm
