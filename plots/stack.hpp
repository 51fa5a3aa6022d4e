/// The rows of a sweep, stacked; and of each run the one error that is looked at, with the order and the time that belong to it.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "plots/sweep.hpp"

namespace mpm {

struct StackedRow {
    int variant;
    SummaryRow row;
};

/// The rows of all runs that have ended, `order` filled in within each variant. With `all`, a run that has not ended is a failed row too.
std::vector<StackedRow> stack(const std::string& folder, const std::vector<Run>& runs, bool all);
void write_stack(const std::string& path, const std::vector<StackedRow>& rows);
bool all_well(const std::vector<StackedRow>& rows);  // whether every verdict is ok

/// The names of the errors in the rows, in their order.
std::vector<std::string> error_names(const std::vector<StackedRow>& rows);

/// One run, seen by one error.
struct Result {
    int cells = 0;
    double h = 0, error = 0, order = 0, seconds = 0;
    long memory_kb = 0;
    std::string verdict, reason;
    std::string program, folder;  // folder: below that of the sweep
    bool ok() const { return verdict == "ok"; }
    bool fits() const;  // has an error that a logarithm can be taken of
};
struct Series {
    std::string name;
    std::vector<Result> results;                // in the order of the sweep
    double order() const;                       // fitted to those that fit; nan with fewer than two
    const Result* reached(double error) const;  // the fastest that is as good, if any
};
/// `cpu`: the seconds are CPU seconds of the method, which other work on the machine does not stretch, else those of the clock on the wall.
std::vector<Series> series(const std::vector<Run>& runs, const std::vector<StackedRow>& rows, const std::string& error, bool cpu = false);

/// Whether no run beats this one (plots/pareto.hpp).
bool unbeaten(const Result& one, const std::vector<Series>& all);

/// The slope of log(error) over log(h) by least squares; nan if there is none.
double fitted_order(const std::vector<std::pair<double, double>>& h_and_error);

/// Variant, cells, error, order, seconds, memory, verdict; and in how many seconds each variant reached 1 %, 0.1 % ...
std::string comparison_table(const std::vector<Series>& all, const std::string& error);
std::string reached_lines(const std::vector<Series>& all);

}  // namespace mpm
