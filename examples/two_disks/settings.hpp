/// What the command line of two_disks says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/improved/transfers.hpp"
#include "chapters/scenes/two_disks.hpp"
#include "lab/program.hpp"

namespace mpm {

struct TwoDisksSettings {
    Common common;
    DiskSettings disks;
    TransferChoice transfer;
    std::string scheme = "musl";
    double cutoff = 0;  // of USL
};

Assembled usl_disks(const TwoDisksSettings& settings, int cells);
Assembled usf_disks(const TwoDisksSettings& settings, int cells);
Assembled musl_disks(const TwoDisksSettings& settings, int cells);
Assembled tlmpm_disks(const TwoDisksSettings& settings, int cells);

}  // namespace mpm
