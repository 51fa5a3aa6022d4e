/// Joins a scheme and a scene with one weighting function and one transfer.
#pragma once
#include <type_traits>

#include "chapters/weighting/shapes.hpp"
#include "chapters/weighting/tensor.hpp"
#include "lab/assemble.hpp"

namespace mpm {

/// One resolution. Particles of GIMP functions have the size of their part of a cell.
template <class Kernel, bool TotalLagrangian, class Scheme, class Scene, class Transfer, class Coupling = Free>
Assembled assemble_with(const Scheme& scheme, const Scene& scene, const Transfer& transfer, int cells, const Common& common,
                        const Coupling& coupling = {}) {
    using Moving = Tensor<Scene::D, Kernel>;
    using Shape = std::conditional_t<TotalLagrangian, Stored<Moving>, Moving>;
    const auto make_shape = [&](const auto& lattice, const auto& points) {
        const Moving moving{lattice, sized<Kernel>(common.ppc)};
        if constexpr (TotalLagrangian) return Shape(moving, points);
        else return moving;
    };
    return assemble<Shape>(scheme, scene, transfer, facts_of<Kernel>(), cells, common, make_shape, coupling);
}

}  // namespace mpm
