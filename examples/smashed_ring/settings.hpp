/// What the command line of smashed_ring says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/scenes/smashed_ring.hpp"
#include "lab/program.hpp"

namespace mpm {

struct SmashedRingSettings {
    Common common;
    RingSettings ring;
    std::string scheme = "musl";
    double alpha = 1;   // 1 = FLIP, 0 = PIC [-]
    double cutoff = 0;  // of USL [mass]
};

Assembled usl_ring(const SmashedRingSettings& settings, int cells);
Assembled usf_ring(const SmashedRingSettings& settings, int cells);
Assembled musl_ring(const SmashedRingSettings& settings, int cells);

}  // namespace mpm
