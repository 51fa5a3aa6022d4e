/// Joins a scheme and a transfer with the manufactured segment and the weighting functions that suit them.
#pragma once
#include <type_traits>

#include "chapters/weighting/shapes.hpp"
#include "chapters/weighting/tensor.hpp"
#include "examples/mms_segment/settings.hpp"
#include "lab/assemble.hpp"

namespace mpm {

/// One resolution with a kernel.
template <class Kernel, bool TotalLagrangian, class Scheme, class Transfer>
Assembled segment_with(const SegmentSettings& s, const Scheme& scheme, const Transfer& transfer, int cells) {
    using Moving = Tensor<1, Kernel>;
    using Shape = std::conditional_t<TotalLagrangian, Stored<Moving>, Moving>;
    Segment<TotalLagrangian> scene;
    static_cast<SegmentMotion&>(scene) = s.scene;
    scene.placing = s.scene.placing;
    scene.force = s.scene.force;
    return assemble<Shape>(scheme, scene, transfer, cells, s.common, [&](const auto& lattice, const auto& points) {
        const Moving moving{lattice, sized<Kernel>(s.common.ppc)};
        if constexpr (TotalLagrangian) return Shape(moving, points);
        else return moving;
    });
}

/// One resolution with the kernel that `--shape` names among `Shapes`.
template <class Shapes, bool TotalLagrangian, class Scheme, class Transfer>
Assembled segment(const SegmentSettings& s, const Scheme& scheme, const Transfer& transfer, int cells) {
    Assembled a;
    Shapes::with(s.common.shape, [&](auto kernel) { a = segment_with<decltype(kernel), TotalLagrangian>(s, scheme, transfer, cells); });
    return a;
}

}  // namespace mpm
