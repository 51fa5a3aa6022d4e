/// Joins a scheme and a scene with the weighting function and the transfer that the command line names.
#pragma once
#include "chapters/improved/transfers.hpp"
#include "chapters/weighting/assemble_with.hpp"

namespace mpm {

/// One resolution with `--shape` of `Shapes` and `--transfer`.
template <class Shapes, bool TotalLagrangian, class Scheme, class Scene>
Assembled assemble_named(const Scheme& scheme, const Scene& scene, const TransferChoice& choice, int cells, const Common& common) {
    Assembled a;
    choice.with<TotalLagrangian>([&](const auto& transfer) {
        Shapes::with(common.shape,
                     [&](auto kernel) { a = assemble_with<decltype(kernel), TotalLagrangian>(scheme, scene, transfer, cells, common); });
    });
    return a;
}

}  // namespace mpm
