/// What to use when: of each compared case, what every variant reaches and in how many seconds, and which are not beaten by another.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "lab/csv_read.hpp"

namespace mpm {

inline constexpr std::array<double, 3> error_levels{1e-2, 1e-3, 1e-4};

/// One run: what it reached. nan: there is none.
struct Reached {
    double error, seconds;
    int cells;
};

/// A variant of a comparison. Only runs that ended well count.
struct Finding {
    std::string name;                 // as in the figures' legends
    Reached finest;                   // the smallest error that it reached
    std::array<Reached, 3> levels{};  // the fastest run as good as error_levels[i]
    bool best = false;                // one of its runs is beaten by none (plots/pareto.hpp)
    std::string trouble;              // how many runs did not end well, and why; "" if all did
};

/// The variants of a comparison's errors.csv, best first.
std::vector<Finding> findings(const CsvTable& errors);

/// The command of a summary row as far as it tells it: program and options other than the resolution.
std::string command_of(const CsvTable& rows, std::size_t row);

/// Writes figures/findings.html: what data/atlas-* found, if there is any, and the chapters' notes. The file `title` of each of these
/// folders has three lines: title, name of the error, class of problem. Throws FileTrouble.
void write_findings(const std::string& chapters, const std::string& figures);

}  // namespace mpm
