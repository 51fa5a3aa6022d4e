/// Joins an updated-Lagrangian scheme with the bar and the weighting functions.
#pragma once
#include "chapters/explicit/flip.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "examples/flying_bar/settings.hpp"

namespace mpm {

/// One resolution with --shape.
template <class Scheme> Assembled updated_flying(const FlyingSettings& s, const Scheme& scheme, int cells) {
    Assembled a;
    FlyingShapes::with(s.common.shape, [&](auto kernel) {
        a = assemble_with<decltype(kernel), false>(scheme, FlyingBar<false>(s.scene, cells), Flip{s.transfer.alpha}, cells, s.common);
    });
    return a;
}

}  // namespace mpm
