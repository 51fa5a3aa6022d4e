/// Joins an updated-Lagrangian scheme with the square and the weighting functions.
#pragma once
#include "chapters/explicit/flip.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "examples/affine_motion/settings.hpp"

namespace mpm {

/// One resolution with --shape.
template <class Scheme> Assembled updated_affine(const AffineSettings& s, const Scheme& scheme, int cells) {
    const Affine<false> scene(s.scene, s.common.shape == Hat::name ? 1 : 2);
    Assembled a;
    AffineShapes::with(s.common.shape, [&](auto kernel) {
        a = assemble_with<decltype(kernel), false>(scheme, scene, Flip{s.transfer.alpha}, cells, s.common);
    });
    return a;
}

}  // namespace mpm
