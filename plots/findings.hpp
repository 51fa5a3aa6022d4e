/// What to use when: of each compared case, what every variant reaches and in how many seconds, and which are not beaten by another.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "lab/csv_read.hpp"

namespace mpm {

inline constexpr std::array<double, 3> error_levels{1e-2, 1e-3, 1e-4};

/// A variant of a comparison by one error. Only runs that ended well count.
struct Finding {
    std::string command;              // program and options, without the resolution
    double error = 0, seconds = 0;    // the smallest error that it reached, and in what time
    std::array<double, 3> reached{};  // seconds to be as good as error_levels[i]; nan: never
    bool best = false;                // one of its runs is beaten by nobody's: none is as good and as fast
    std::string trouble;              // the verdict of a run that did not end well, if there is one
};

/// The variants of stacked summary rows (compare.csv) by the error of this name ("": the first that is named), best first.
std::vector<Finding> findings(const CsvTable& rows, const std::string& error_name);

/// The command of a summary row as far as it tells it: program and options other than the resolution.
std::string command_of(const CsvTable& rows, std::size_t row);

/// The chapter of the gallery that tells the findings of data/atlas-*, if there are any: HTML. Each folder has a file `title`, whose second
/// line names the error. Throws FileTrouble.
std::string findings_html(const std::string& figures);

}  // namespace mpm
