/// The `main` body of every program: options, one run for each resolution, files, report and exit code.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "lab/coverage.hpp"
#include "lab/figure.hpp"
#include "lab/monitor.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"
#include "lab/run.hpp"
#include "lab/table.hpp"

namespace mpm {

/// What the options depend on: of a scene by traits_of (lab/traits.hpp).
struct SceneTraits {
    bool period = false;                   // it has a period: --periods is an option
    std::vector<std::string> colours{};    // in 2D: the columns of a snapshot, for --colour
    std::string colour{};                  // the one that is shown unless told
    std::string limit = wave_limit;        // what --cfl is a fraction of
};

/// Options that every program has (DESIGN.md section 4).
struct Common {
    std::vector<int> cells{50};
    int ppc = 1;
    std::string shape = "hat";
    double cfl = 0.1, dt = 0, t_end = 0, periods = 0;
    std::string dt_from = "start";
    std::string out, label, config, plot = "none", format = "csv", colour, watch = "stop";
    int records = 4000, frames = 0, repeat = 1, threads = 1;
    bool smooth = false, quiet = false, dry_run = false;
    std::string limit = wave_limit;  // what `cfl` is a fraction of

    void declare(Options& o, const std::vector<std::string>& shapes, double default_t_end, const SceneTraits& traits = {});
    /// `--threads`, for programs in two dimensions.
    void declare_threads(Options& o);
    /// The same with t_end made of --periods, if given.
    Common with_period(double period) const;
};

/// What a program needs of one assembled resolution besides the loop's view of it.
struct Assembled {
    Simulation simulation;
    SummaryRow row;                 // dimensions, sizes and names filled in
    std::function<std::vector<NamedError>(double t_end)> errors;
    std::function<std::vector<std::pair<std::string, double>>(double t_end)> facts;
    std::function<NodeWatch()> nodes;  // rare events on the grid
    double critical_dt = 0;         // h/(c + |v|)
    Animated animated;              // what --plot gif shows
};

/// What a scene and a scheme say of themselves, for the screen.
struct Description {
    std::string program, purpose, scene, solves;
    std::vector<std::string> columns;
    double period = 0;  // [time]; the history's figure shows ten
    std::vector<Panel> panels = {};  // of the history's figure, above the energies; empty: one of all watched columns
    bool moves = true;               // the figure shows energies and momentum
};

/// Runs every resolution and writes everything; returns the exit code.
int run_program(const Description& about, const Options& options, const Common& common,
                const std::function<Assembled(int cells)>& assemble);

/// A plan of whole steps, none longer than `wanted`, the last of which ends at t_end. Throws BadInput for more than 1e10.
RunPlan whole_steps(double t_end, double wanted, double critical_dt);
/// Fills in what a run has shown, all but its errors.
void add_result(SummaryRow& row, const RunPlan& plan, const RunResult& result);

/// The folder of a run's files: `out`, or out/<program>/<label> with a label made of the options if there is none. Throws BadInput.
std::string run_folder(const std::string& program, const Options& options, const std::string& out, const std::string& label);
/// Throws FileTrouble.
void make_folder(const std::string& path);
/// Turns exceptions into one line on stderr and the exit code of the contract.
int guarded(const std::string& program, const std::function<int()>& main_body);
/// Answers --help, --version and --describe; true if one was asked for.
bool answered(const Options& options, const std::string& program);

}  // namespace mpm
