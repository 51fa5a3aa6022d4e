/// Joins a scheme and a transfer with the manufactured segment and the weighting functions that suit them.
#pragma once
#include "chapters/weighting/assemble_with.hpp"
#include "examples/mms_segment/settings.hpp"

namespace mpm {

/// One resolution with a kernel.
template <class Kernel, bool TotalLagrangian, class Scheme, class Transfer>
Assembled segment_with(const SegmentSettings& s, const Scheme& scheme, const Transfer& transfer, int cells) {
    Segment<TotalLagrangian> scene;
    static_cast<SegmentMotion&>(scene) = s.scene;
    scene.placing = s.scene.placing;
    scene.force = s.scene.force;
    return assemble_with<Kernel, TotalLagrangian>(scheme, scene, transfer, cells, s.common);
}

/// One resolution with the kernel that `--shape` names among `Shapes`.
template <class Shapes, bool TotalLagrangian, class Scheme, class Transfer>
Assembled segment(const SegmentSettings& s, const Scheme& scheme, const Transfer& transfer, int cells) {
    Assembled a;
    Shapes::with(s.common.shape, [&](auto kernel) { a = segment_with<decltype(kernel), TotalLagrangian>(s, scheme, transfer, cells); });
    return a;
}

/// One resolution with `--shape` of `Shapes` and `--transfer`.
template <class Shapes, bool TotalLagrangian, class Scheme> Assembled segment(const SegmentSettings& s, const Scheme& scheme, int cells) {
    Assembled a;
    s.transfer.with<TotalLagrangian>([&](const auto& transfer) { a = segment<Shapes, TotalLagrangian>(s, scheme, transfer, cells); });
    return a;
}

}  // namespace mpm
