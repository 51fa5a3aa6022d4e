#include "lab/run.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>

#include "lab/record.hpp"

namespace mpm {
namespace {

volatile std::sig_atomic_t stop_requested = 0;
void on_signal(int) { stop_requested = 1; }

/// A likely cause that the numbers support, added to what was seen.
std::string likely_cause(const RunPlan& plan) {
    const double ratio = plan.dt / plan.critical_dt;
    char text[160];
    if (ratio > 1)
        std::snprintf(text, sizeof text, "; likely cause: the time step is %.3g times h/(c + |v|)", ratio);
    else
        std::snprintf(text, sizeof text, "; the time step is %.3g of h/(c + |v|), so look at the scheme", ratio);
    return text;
}

std::string frame_name(const std::string& folder, const char* what, long number) {
    char name[40];
    std::snprintf(name, sizeof name, "/%s_%04ld.csv", what, number);
    return folder + name;
}

void show_progress(double fraction) {
    std::fprintf(stdout, "\r[%-40.*s] %3.0f %%", static_cast<int>(40 * fraction),
                 "########################################", 100 * fraction);
    std::fflush(stdout);
}

}  // namespace

void catch_interrupts() {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
}
bool interrupted() { return stop_requested != 0; }

RunResult run(Simulation& sim, const RunPlan& plan) {
    RunResult result;
    std::vector<std::string> columns{"t", "kinetic", "strain", "total", "momentum"};
    columns.insert(columns.end(), plan.columns.begin(), plan.columns.end());
    CsvFile history(plan.folder + "/history.csv", columns);
    result.files.push_back(history.path());
    EnergyWatch energy_watch;
    Stopwatch watch;
    Measures start{}, now{};
    double in_play = 0;
    Trouble trouble;
    const long records = std::clamp<long>(plan.records, 1, plan.steps);

    const auto record = [&](double t) {
        now = sim.measure();
        in_play = std::max(in_play, now.total());
        std::vector<double> row{t, now.kinetic, now.strain, now.total(), now.momentum};
        const std::vector<double> own = sim.watch(t);
        row.insert(row.end(), own.begin(), own.end());
        history.row(row.data(), row.size());
        return energy_watch.check(now.total());
    };
    const auto snapshot = [&](long number) {
        sim.write_particles(frame_name(plan.folder, "particles", number));
        sim.write_nodes(frame_name(plan.folder, "nodes", number));
    };

    trouble = record(0);
    start = now;
    sim.sample(0, sim.wants_energy(0) ? now.total() : std::nan(""));
    if (plan.frames > 0) snapshot(0);
    long k = 0;
    double t = 0;
    while (k < plan.steps && !trouble) {
        try {
            watch.start();
            sim.step(t, plan.dt);
            watch.stop();
            trouble = sim.check();
        } catch (const OutsideGrid& outside) {
            watch.stop();
            trouble = {"left-grid", outside.what()};
        }
        ++k;
        t = static_cast<double>(k) * plan.dt;
        if (trouble) break;
        sim.sample(t, sim.wants_energy(t) ? sim.measure().total() : std::nan(""));
        if (k * records / plan.steps != (k - 1) * records / plan.steps) {
            Trouble growth = record(t);
            if (!growth) sim.keep();
            if (growth && (plan.stop_on_trouble || !std::isfinite(now.total()))) trouble = growth;
            else if (growth && !result.trouble) result.trouble = growth, result.t_fail = t;
            if (plan.progress) show_progress(static_cast<double>(k) / static_cast<double>(plan.steps));
        }
        if (plan.frames > 0 && k * plan.frames / plan.steps != (k - 1) * plan.frames / plan.steps)
            snapshot(k * plan.frames / plan.steps);
        if (stop_requested) {
            result.interrupted = true;
            break;
        }
    }
    if (plan.progress) std::fprintf(stdout, "\r%50s\r", "");
    if (trouble) {
        if (trouble.cause != "energy-growth") {  // the last state that was recorded says how the energy stood
            const Trouble growth = energy_watch.growth() > 0.5 * EnergyWatch::limit ? Trouble{"energy-growth", ""} : Trouble{};
            if (growth) trouble.cause = growth.cause;
        }
        trouble.reason += likely_cause(plan);
        result.trouble = trouble;
        result.t_fail = t;
        sim.restore();
    }
    if (trouble || result.interrupted) {
        const std::string path = plan.folder + "/particles_last_good.csv";
        sim.write_particles(path);
        result.files.push_back(path);
    }
    result.t = t;
    result.steps = k;
    result.wall = watch.wall;
    result.cpu = watch.cpu;
    result.energy_drift = (now.total() - start.total()) / in_play;
    result.momentum_drift = now.momentum - start.momentum;
    result.energy_growth = energy_watch.growth();
    return result;
}

}  // namespace mpm
