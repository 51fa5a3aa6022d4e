/// What programs that are no single run in time have in common: where their files go, the picture, the list of what was written.
#pragma once
#include <string>
#include <vector>

#include "lab/options.hpp"

namespace mpm {

struct Study {
    std::string out, label, plot = "none";
    bool quiet = false;

    /// --out, --label, --plot, --quiet; none of them is part of a run's name.
    void declare(Options& options);
};

/// "written: ..." on the screen.
void say_written(const std::vector<std::string>& files);

}  // namespace mpm
