/// Joins a scheme with the ring.
#pragma once
#include "chapters/explicit/flip.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "examples/smashed_ring/settings.hpp"

namespace mpm {

/// One resolution with `--shape`.
template <class Scheme> Assembled ring(const SmashedRingSettings& s, const Scheme& scheme, int cells) {
    Assembled a;
    UpdatedShapes::with(s.common.shape, [&](auto kernel) {
        using Kernel = decltype(kernel);
        const SmashedRing scene(s.ring, cells, Kernel::support);
        a = assemble_with<Kernel, false>(scheme, scene, Flip{s.alpha}, cells, s.common);
    });
    return a;
}

}  // namespace mpm
