#include "lab/run.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <utility>

#include "lab/progress.hpp"
#include "lab/record.hpp"

namespace mpm {
namespace {

volatile std::sig_atomic_t stop_requested = 0;
void on_signal(int) { stop_requested = 1; }

/// Steps below this part of the first one go nowhere.
constexpr double step_floor = 1e-6;

std::vector<std::string> history_columns(const RunPlan& plan) {
    std::vector<std::string> names{"t", "kinetic", "strain", "total"};
    if (plan.dim == 1)
        names.emplace_back("momentum");
    else
        names.insert(names.end(), {"momentum_x", "momentum_y"});
    names.insert(names.end(), plan.columns.begin(), plan.columns.end());
    return names;
}

/// A run in progress: its state between steps.
class Runner {
public:
    Runner(Simulation& sim, const RunPlan& plan)
        : sim_(sim),
          plan_(plan),
          records_(std::clamp<long>(plan.records, 1, plan.steps)),
          history_(plan.folder + "/history.csv", history_columns(plan)),
          energy_(step_ratio()) {
        result_.files.push_back(history_.path());
    }

    RunResult go() {
        Progress progress(plan_.progress);
        start();
        while (!finished() && !stopped_by_) {
            step();
            if (stopped_by_) break;
            records();
            progress.at(t_ / plan_.t_end);
            if (stop_requested != 0) {
                result_.interrupted = true;
                break;
            }
        }
        return finish();
    }

private:
    bool finished() const { return plan_.cfl > 0 ? t_ >= plan_.t_end : result_.steps >= plan_.steps; }

    /// Goes to the next time: whole steps of dt, or what the wave and particle speeds allow now.
    void advance() {
        if (plan_.cfl > 0) {
            const double dt = std::min(plan_.cfl * sim_.critical_dt(), plan_.t_end - t_);
            next_ = dt < plan_.t_end - t_ ? t_ + dt : plan_.t_end;
            if (dt < step_floor * plan_.dt && next_ < plan_.t_end)
                stopped_by_ = {"time-step-floor", "the step fell to " + number_text(dt) + ", below 1e-6 of the first"};
            dt_ = dt;
        } else {
            next_ = static_cast<double>(result_.steps + 1) * plan_.dt;
            dt_ = plan_.dt;
        }
    }

    void start() {
        now_ = first_ = sim_.measure();
        record();
        sim_.sample(0, sim_.wants_energy(0) ? now_.total() : std::nan(""));
        if (plan_.frames > 0) snapshot(0);
    }

    void step() {
        advance();
        if (stopped_by_) return;
        watch_.start();
        try {
            sim_.step(t_, dt_);
            watch_.stop();
            note(sim_.check());
        } catch (const OutsideGrid& outside) {
            watch_.stop();
            stopped_by_ = {"left-grid", outside.what()};
        }
        if (sim_.supply && !stopped_by_) {
            const Supply s = sim_.supply(t_, dt_);
            for (const std::size_t d : {0, 1}) supplied_.impulse[d] += s.impulse[d];
            supplied_.work += s.work;
        }
        ++result_.steps;
        t_ = next_;
    }

    /// Number of the part out of `parts` that the run is in after this step.
    long part(long parts, long step, double t) const {
        if (plan_.cfl > 0) return static_cast<long>(static_cast<double>(parts) * t / plan_.t_end);
        return step * parts / plan_.steps;
    }

    void records() {
        sim_.sample(t_, sim_.wants_energy(t_) ? sim_.measure().total() : std::nan(""));
        const long step = result_.steps;
        const bool is_record = part(records_, step, t_) != part(records_, step - 1, t_ - dt_);
        if (is_record || energy_.suspicious()) {
            now_ = sim_.measure();
            so_far_ = supplied_;
            const Trouble growth = energy_.check(now_, so_far_.work);
            if (is_record) {
                record();
                const Trouble gap = sim_.inspect();
                if (!growth && !gap && !energy_.suspicious()) sim_.keep();
                note(gap);
            }
            note(growth);
        }
        const long frame = plan_.frames > 0 ? part(plan_.frames, step, t_) : 0;
        if (frame != (plan_.frames > 0 ? part(plan_.frames, step - 1, t_ - dt_) : 0)) snapshot(frame);
    }

    void record() {
        if (result_.steps == 0) energy_.check(now_, 0);
        std::vector<double> row{t_, now_.kinetic, now_.strain, now_.total(), now_.momentum[0]};
        if (plan_.dim == 2) row.push_back(now_.momentum[1]);
        const std::vector<double> own = sim_.watch(t_);
        row.insert(row.end(), own.begin(), own.end());
        history_.row(row.data(), row.size());
        momentum_in_play_ = std::max(momentum_in_play_, now_.momentum_in_play);
    }

    void snapshot(long number) {
        result_.frames.push_back({number, t_});
        char digits[24];
        std::snprintf(digits, sizeof digits, "_%04ld", number);
        write(sim_.particles(), plan_.particles, std::string("particles") + digits);
        write(sim_.nodes(), plan_.nodes, std::string("nodes") + digits);
        if (sim_.domains && plan_.particles.csv) write_polygons(plan_.folder + "/domains" + digits + ".csv", sim_.domains());
        if (plan_.particles.vtk) vtk_frames_.emplace_back(digits, t_);
    }

    template <class Table> void write(const Table& table, const SnapshotFormat& format, const std::string& name) const {
        const std::string path = plan_.folder + "/" + name;
        if (format.csv) write_csv(path + ".csv", table);
        if (format.vtk) write_vtk(path + ".vtk", name + ", t = " + number_text(t_), table);
    }

    /// The list of snapshots that ParaView reads as a film.
    void write_series() {
        for (const std::string what : {"particles", "nodes"}) {
            std::vector<std::pair<std::string, double>> files;
            for (const auto& [digits, t] : vtk_frames_) files.emplace_back(what + digits + ".vtk", t);
            result_.files.push_back(plan_.folder + "/" + what + ".vtk.series");
            write_vtk_series(result_.files.back(), files);
        }
    }

    /// Trouble stops the run, or is kept for its end with `--watch warn` while numbers are still numbers.
    void note(const Trouble& trouble) {
        if (!trouble || stopped_by_) return;
        if (!result_.trouble) {
            result_.trouble = trouble;
            if (trouble.cause != "bodies-passed-through" && trouble.cause != "locking") result_.trouble.reason += "; " + sim_.where();
            result_.t_fail = next_;
        }
        if (plan_.stop_on_trouble || trouble.cause == "not-finite") stopped_by_ = trouble;
    }

    /// What the numbers say about the cause: an energy that had begun to grow, a step beyond the critical one.
    void explain() {
        Trouble& trouble = result_.trouble;
        if (!trouble)
            trouble = stopped_by_, result_.t_fail = next_;
        else if (stopped_by_ && result_.t_fail < next_)  // warned of before
            trouble.reason += "; stopped at t = " + number_text(next_) + " by " + stopped_by_.cause + ": " + stopped_by_.reason;
        if (trouble.cause != "energy-growth" && trouble.cause != "locking" && energy_.growth() > 0.5 * EnergyWatch::limit) {
            trouble.reason += "; the energy had grown by " + percent(energy_.growth()) + " of that in play";
            trouble.cause = "energy-growth";
        }
        const double ratio = step_ratio();
        char text[120];
        std::snprintf(text, sizeof text,
                      ratio > 1 ? "; likely cause: the time step is %.3g times %s" : "; the time step is %.3g of %s, so look at the scheme",
                      ratio, plan_.limit.c_str());
        const bool at_any_step =
            trouble.cause == "numerical-fracture" || trouble.cause == "bodies-passed-through" || trouble.cause == "locking" ||
            trouble.cause == "massless-node";
        if (!at_any_step && !sim_.any_step) trouble.reason += text;
    }
    double step_ratio() const { return plan_.cfl > 0 ? plan_.cfl : plan_.dt / plan_.critical_dt; }
    static std::string percent(double part) {
        char text[32];
        std::snprintf(text, sizeof text, "%.3g %%", 100 * part);
        return text;
    }

    RunResult finish() {
        if (result_.trouble || stopped_by_) explain();
        result_.stopped = stopped_by_ || result_.interrupted;
        if (stopped_by_) sim_.restore();
        if (result_.stopped) {
            const std::string name = "particles_last_good";
            write(sim_.particles(), plan_.particles, name);
            result_.files.push_back(plan_.folder + "/" + name + (plan_.particles.csv ? ".csv" : ".vtk"));
        }
        if (!vtk_frames_.empty()) write_series();
        result_.t = t_;
        result_.wall = watch_.wall;
        result_.cpu = watch_.cpu;
        result_.energy_drift = energy_.in_play() > 0 ? (now_.balance() - so_far_.work - first_.balance()) / energy_.in_play() : 0;
        const auto lost = [&](std::size_t d) { return now_.momentum[d] - first_.momentum[d] - so_far_.impulse[d]; };
        const double in_play = std::max(momentum_in_play_, std::hypot(so_far_.impulse[0], so_far_.impulse[1]));
        result_.momentum_in_play = momentum_in_play_;
        result_.momentum_drift = in_play > 0 ? std::hypot(lost(0), lost(1)) / in_play : 0;
        return result_;
    }

    Simulation& sim_;
    const RunPlan& plan_;
    const long records_;
    CsvFile history_;
    RunResult result_;
    Trouble stopped_by_;
    EnergyWatch energy_;
    Stopwatch watch_;
    Measures first_, now_;
    Supply supplied_, so_far_;  // now, and at the last record
    double momentum_in_play_ = 0;
    std::vector<std::pair<std::string, double>> vtk_frames_;  // numbers as in the files' names, times
    double t_ = 0, next_ = 0, dt_ = 0;
};

}  // namespace

void catch_interrupts() {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
}
bool interrupted() { return stop_requested != 0; }

RunResult run(Simulation& simulation, const RunPlan& plan) { return Runner(simulation, plan).go(); }

}  // namespace mpm
