/// What the command line of dam_break says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/fluid/dam.hpp"
#include "lab/program.hpp"

namespace mpm {

struct DamBreakSettings {
    Common common;
    DamSettings dam;
    std::string scheme = "musl";
    double alpha = 1, cutoff = 0;  // mix of FLIP and PIC; of USL
};

Assembled musl_dam(const DamBreakSettings& settings, int cells);
Assembled usl_dam(const DamBreakSettings& settings, int cells);

}  // namespace mpm
