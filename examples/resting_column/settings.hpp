/// What the command line of resting_column says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/scenes/loaded_column.hpp"
#include "lab/program.hpp"

namespace mpm {

struct RestingColumnSettings {
    Common common;
    RestingColumn column;
    double damping = 0.5;
    std::string scheme = "tlmpm";
};

Assembled musl_resting_column(const RestingColumnSettings& settings, int cells);
Assembled tlmpm_resting_column(const RestingColumnSettings& settings, int cells);

}  // namespace mpm
