/// Weighting functions that are products of one-dimensional ones (review 3.3), and their total-Lagrangian store.
#pragma once
#include <cstddef>
#include <vector>

#include "lab/stencil.hpp"

namespace mpm {

/// The weighting function of a body, made of a one-dimensional `Kernel`. A kernel has
///   name        what `--shape` calls it;
///   support     nodes a point touches along an axis;
///   min_cells   fewest cells along an axis;
///   per_cell    nodes per cell and axis;
/// and is called as kernel(xi, cells) with xi in cells from the lower end of a grid of `cells` cells, giving AxisWeights. A
/// kernel that needs the particle's size is called as kernel(xi, cells, size), size [cells] from kernel.size(p, axis).
/// Kernels fold what reaches past an end of the grid onto the grid: c_-1 = 2 c_0 - c_1 (zero second derivative, review 3.4).
template <int D, class KernelType> struct Tensor {
    using Kernel = KernelType;
    static constexpr int dim = D, N = Kernel::support;
    static constexpr int rows = N;            // of nodes that a particle touches; threads share the particles by them
    static constexpr bool numbered = false;   // keeps nothing by a particle's place
    static constexpr bool total_lagrangian = false;

    Lattice<D> lattice;
    Kernel kernel{};

    template <class Point> [[gnu::always_inline]] Stencil<D, power(N, D)> at(const Vec<D>& x, const Point& p) const {
        return tensor_stencil<D, N>(lattice, x, [&](int axis, double xi) {
            const int cells = lattice.cells(axis);
            if constexpr (requires { kernel.size(p, axis); })
                return kernel(xi, cells, kernel.size(p, axis));
            else
                return kernel(xi, cells);
        });
    }
    template <class Point> [[gnu::always_inline]] Stencil<D, power(N, D)> operator()(const Point& p, std::size_t) const { return at(p.x, p); }
};

/// Weights evaluated once, at the initial positions, and kept: the shape of every total-Lagrangian scheme (review 2.6). They have forgotten their
/// function: a step is compiled for each size of stencil, not for each function.
template <int D, int Support> class StoredWeights {
public:
    static constexpr int rows = Support;
    static constexpr bool total_lagrangian = true;
    StoredWeights() = default;
    template <class Shape, class Points> StoredWeights(const Shape& shape, const Points& points) {
        stencils_.reserve(points.size());
        for (const auto& p : points) stencils_.push_back(shape.at(p.X, p));
    }
    template <class Point> const auto& operator()(const Point&, std::size_t i) const { return stencils_[i]; }

private:
    std::vector<Stencil<D, power(Support, D)>> stencils_;
};
template <class Shape> using Stored = StoredWeights<Shape::dim, Shape::N>;

}  // namespace mpm
