/// What the command line of affine_motion says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/improved/transfers.hpp"
#include "chapters/mms/affine.hpp"
#include "chapters/weighting/shapes.hpp"
#include "lab/program.hpp"

namespace mpm {

using AffineShapes = ShapeList<Hat, Cpgimp, Cubic>;

struct AffineSettings {
    Common common;
    AffineCase scene;
    TransferChoice transfer;
    std::string scheme = "tlmpm", stress = "musl";
};

Assembled usl_affine(const AffineSettings& settings, int cells);
Assembled usf_affine(const AffineSettings& settings, int cells);
Assembled musl_affine(const AffineSettings& settings, int cells);
Assembled tlmpm_affine(const AffineSettings& settings, int cells);
Assembled impm_affine(const AffineSettings& settings, int cells);
Assembled cpdi_affine(const AffineSettings& settings, int cells);

}  // namespace mpm
