/// What the command line of steel_disk says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/scenes/steel_disk.hpp"
#include "lab/program.hpp"

namespace mpm {

struct SteelDiskSettings {
    Common common;
    ImpactSettings impact;
    std::string scheme = "musl", transfer = "flip";
    double alpha = 1, cutoff = 0;  // mix of FLIP and PIC; of USL
};

Assembled usl_impact(const SteelDiskSettings& settings, int cells);
Assembled usf_impact(const SteelDiskSettings& settings, int cells);
Assembled musl_impact(const SteelDiskSettings& settings, int cells);

}  // namespace mpm
