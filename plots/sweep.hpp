/// A sweep: every variant at every resolution, each run in a folder and process of its own. What has ended stands on the disk, so that a
/// sweep goes on where it was stopped, and it does not matter who ran what.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lab/table.hpp"
#include "plots/process.hpp"
#include "plots/variant.hpp"

namespace mpm {

/// One run, as a row of sweep.csv keeps it.
struct Run {
    int variant = 0;                     // counted from 0
    std::string name, shared;            // of the variant in legends; what all variants have in common
    std::string program, options, text;  // its command, without the folder where it writes
    int cells = 0;
    std::string folder;  // below that of the sweep
    Command command;     // not kept
};

/// What a folder holds of a run: one row at least, for a run that failed is a row too.
struct Outcome {
    bool ended = false;
    std::vector<SummaryRow> rows;
};

struct RunRules {
    int jobs = 1;
    double timeout = 0;  // seconds; 0: none
    bool fresh = false;  // run again what is there
};

/// The runs of a sweep: the words that each command gets beside the variant's own are those which the program accepts.
std::vector<Run> plan_sweep(Programs& programs, const std::vector<Variant>& variants, const std::vector<int>& cells,
                            const std::string& folder);
void write_sweep(const std::string& folder, const std::vector<Run>& runs);
std::vector<Run> read_sweep(const std::string& folder);

/// Whether the folder holds what this very command wrote, ended and readable, and the program has not been built since.
bool is_complete(const std::string& folder, const Run& run);

/// Runs what is not complete. Returns false when it was interrupted; the runs that had ended stay. `after` is called after each.
bool run_sweep(const std::string& folder, const std::vector<Run>& runs, const RunRules& rules,
               const std::function<void(const Run&)>& after);

/// Runs one, whatever is there, and says what has become of it; nothing when interrupted.
std::optional<Outcome> run_one(const std::string& folder, const Run& run, double timeout);

/// Makes the folders of what is not complete and returns a line of shell for each.
std::vector<std::string> list_sweep(const std::string& folder, const std::vector<Run>& runs, bool fresh);

/// What has become of a run.
Outcome outcome(const std::string& folder, const Run& run);

}  // namespace mpm
