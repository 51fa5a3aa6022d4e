/// Joins a scheme with the disks.
#pragma once
#include "chapters/improved/variants.hpp"
#include "examples/two_disks/settings.hpp"

namespace mpm {

/// One resolution with `--shape` of `Shapes` and `--transfer`.
template <class Shapes, bool TotalLagrangian, class Scheme> Assembled disks(const TwoDisksSettings& s, const Scheme& scheme, int cells) {
    TwoDisks<TotalLagrangian> scene;
    static_cast<DiskSettings&>(scene) = s.disks;
    scene.t_end = s.common.t_end;
    return assemble_named<Shapes, TotalLagrangian>(scheme, scene, s.transfer, cells, s.common);
}

}  // namespace mpm
