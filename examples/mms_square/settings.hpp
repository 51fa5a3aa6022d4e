/// What the command line of mms_square says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/improved/impm_choice.hpp"
#include "chapters/improved/transfers.hpp"
#include "chapters/mms/square.hpp"
#include "lab/program.hpp"

namespace mpm {

struct SquareSettings {
    Common common;
    SquareCase scene;
    TransferChoice transfer;
    ImpmOptions impm;
    std::string scheme = "tlmpm", stress = "musl";
};

Assembled usl_square(const SquareSettings& settings, int cells);
Assembled usf_square(const SquareSettings& settings, int cells);
Assembled musl_square(const SquareSettings& settings, int cells);
Assembled tlmpm_square(const SquareSettings& settings, int cells);
Assembled impm_square(const SquareSettings& settings, int cells);

}  // namespace mpm
