/// Joins a scheme with the impact.
#pragma once
#include "chapters/explicit/flip.hpp"
#include "chapters/improved/affine.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "examples/steel_disk/settings.hpp"

namespace mpm {

/// One resolution with `--shape` and `--transfer`.
template <class Scheme> Assembled impact(const SteelDiskSettings& s, const Scheme& scheme, int cells) {
    SteelDisk scene;
    static_cast<ImpactSettings&>(scene) = s.impact;
    scene.t_end = s.common.t_end;
    Assembled a;
    UpdatedShapes::with(s.common.shape, [&](auto kernel) {
        if (s.transfer == "apic")
            a = assemble_with<decltype(kernel), false>(scheme, scene, Apic<false>{}, cells, s.common);
        else
            a = assemble_with<decltype(kernel), false>(scheme, scene, Flip{s.alpha}, cells, s.common);
    });
    a.animated = {"x", "y", "eps_p", "x [m]", "y [m]", "equivalent plastic strain [-]"};
    return a;
}

}  // namespace mpm
