/// What the command line of flying_bar says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/improved/transfers.hpp"
#include "chapters/scenes/flying_bar.hpp"
#include "chapters/weighting/shapes.hpp"
#include "lab/program.hpp"

namespace mpm {

/// Enough to tell hat functions, domains and smooth functions apart.
using FlyingShapes = ShapeList<Hat, Cpgimp, Cubic>;

struct FlyingSettings {
    Common common;
    FlyingBarCase scene;
    TransferChoice transfer;
    std::string scheme = "musl";
};

Assembled usl_flying(const FlyingSettings& settings, int cells);
Assembled usf_flying(const FlyingSettings& settings, int cells);
Assembled musl_flying(const FlyingSettings& settings, int cells);
Assembled tlmpm_flying(const FlyingSettings& settings, int cells);
Assembled impm_flying(const FlyingSettings& settings, int cells);
Assembled cpdi_flying(const FlyingSettings& settings, int cells);

}  // namespace mpm
