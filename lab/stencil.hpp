/// What a point touches: the nodes, weights and weighting gradients of one particle, in fixed-size storage.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "lab/grid.hpp"
#include "lab/math.hpp"

namespace mpm {

/// Weights along one axis: `phi[k]` and `dphi[k]` (per cell) belong to node `first + k`.
template <int N> struct AxisWeights {
    int first = 0;
    std::array<double, N> phi{}, dphi{};
};

/// One node of a stencil: its number, weight [-] and weighting gradient [1/length].
template <int D> struct StencilEntry {
    int node;
    double phi;
    Vec<D> grad;
};

template <int D, int N> using Stencil = std::array<StencilEntry<D>, N>;

/// A particle is not inside the grid (or its position is not a number).
struct OutsideGrid : std::runtime_error {
    using std::runtime_error::runtime_error;
};

namespace detail {
[[noreturn, gnu::cold, gnu::noinline]] inline void outside_grid(double x, double low, double high, int axis) {
    throw OutsideGrid("position " + std::to_string(x) + " outside the grid [" + std::to_string(low) + ", " +
                      std::to_string(high) + "] along axis " + std::to_string(axis));
}
}  // namespace detail

/// The tensor product of weights along each axis (review 3.3). This is the one place where node numbers are made: `along(axis,
/// xi)` gives the weights at xi cells from the lower corner, and every number is checked against the lattice, always.
/// Inlined by demand: compilers think it too long, and a call for every particle costs a tenth of a step.
template <int D, int N, class Along>
[[gnu::always_inline]] inline Stencil<D, power(N, D)> tensor_stencil(const Lattice<D>& lattice, const Vec<D>& x, Along&& along) {
    std::array<AxisWeights<N>, D> w;
    for (int d = 0; d < D; ++d) {
        if (!lattice.holds(x[d], d)) [[unlikely]]
            detail::outside_grid(x[d], lattice.origin()[d], lattice.upper()[d], d);
        auto& axis = w[static_cast<std::size_t>(d)];
        axis = along(d, lattice.in_cells(x[d], d));
        if (axis.first < 0 || axis.first + N > lattice.nodes(d)) [[unlikely]]
            detail::outside_grid(x[d], lattice.origin()[d], lattice.upper()[d], d);
    }
    const Vec<D>& r = lattice.per_h();
    Stencil<D, power(N, D)> s;
    if constexpr (D == 1) {
        for (std::size_t i = 0; i < N; ++i)
            s[i] = {w[0].first + static_cast<int>(i), w[0].phi[i], Vec<D>(w[0].dphi[i] * r[0])};
    } else {
        static_assert(D == 2, "stencils are written for one and two dimensions");
        for (std::size_t j = 0; j < N; ++j)
            for (std::size_t i = 0; i < N; ++i) {
                auto& e = s[j * N + i];
                e.node = (w[1].first + static_cast<int>(j)) * lattice.nodes(0) + w[0].first + static_cast<int>(i);
                e.phi = w[0].phi[i] * w[1].phi[j];
                e.grad = Vec<D>(w[0].dphi[i] * r[0] * w[1].phi[j], w[0].phi[i] * w[1].dphi[j] * r[1]);
            }
    }
    return s;
}

}  // namespace mpm
