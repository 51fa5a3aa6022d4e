/// What the command line of vortex says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/improved/transfers.hpp"
#include "chapters/mms/vortex.hpp"
#include "lab/program.hpp"

namespace mpm {

struct VortexSettings {
    Common common;
    VortexCase scene;
    TransferChoice transfer;
    std::string scheme = "tlmpm", stress = "musl";
};

Assembled usl_vortex(const VortexSettings& settings, int cells);
Assembled usf_vortex(const VortexSettings& settings, int cells);
Assembled musl_vortex(const VortexSettings& settings, int cells);
Assembled tlmpm_vortex(const VortexSettings& settings, int cells);

}  // namespace mpm
