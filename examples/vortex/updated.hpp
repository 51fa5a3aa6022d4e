/// Joins an updated-Lagrangian scheme with the vortex and the weighting functions that suit it.
#pragma once
#include "chapters/weighting/assemble_with.hpp"
#include "examples/vortex/settings.hpp"

namespace mpm {

/// One resolution with --shape and --transfer flip; the others are for the TLMPM, they would cost half a minute of compiling each scheme.
template <class Scheme> Assembled updated_vortex(const VortexSettings& s, const Scheme& scheme, int cells) {
    const Flip transfer{s.transfer.alpha};
    Assembled a;
    UpdatedShapes::with(s.common.shape, [&](auto kernel) {
        a = assemble_with<decltype(kernel), false>(scheme, Vortex<false>(s.scene), transfer, cells, s.common);
    });
    return a;
}

}  // namespace mpm
