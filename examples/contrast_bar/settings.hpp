/// What the command line of contrast_bar says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/improved/transfers.hpp"
#include "chapters/scenes/contrast_bar.hpp"
#include "lab/program.hpp"

namespace mpm {

struct ContrastSettings {
    Common common;
    ContrastBar<false> scene;
    TransferChoice transfer;
    std::string scheme = "musl";
};

Assembled usl_contrast(const ContrastSettings& settings, int cells);
Assembled usf_contrast(const ContrastSettings& settings, int cells);
Assembled musl_contrast(const ContrastSettings& settings, int cells);
Assembled tlmpm_contrast(const ContrastSettings& settings, int cells);
Assembled impm_contrast(const ContrastSettings& settings, int cells);
Assembled cpdi_contrast(const ContrastSettings& settings, int cells);

}  // namespace mpm
