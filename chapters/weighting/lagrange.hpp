/// The quadratic Lagrange functions, nodes at the ends and the middle of each cell: the quadratic finite element in one dimension.
#pragma once
#include <algorithm>

#include "lab/stencil.hpp"

namespace mpm {

/// One at their own node and zero at the others, hence negative in between (down to -1/8), and only C0 across cells: for finite elements
/// and total-Lagrangian schemes. Needs two points per cell or more: one in the middle gives the nodes at the ends no mass.
struct Lagrange2 {
    static constexpr const char* name = "lagrange";
    static constexpr int support = 3, min_cells = 1, per_cell = 2;

    AxisWeights<3> operator()(double xi, int cells) const {
        const int cell = std::min(static_cast<int>(xi), cells - 1);
        const double r = xi - cell, q = 1 - r;
        return {2 * cell, {q * (q - r), 4 * r * q, r * (r - q)}, {r - 3 * q, 4 * (q - r), 3 * r - q}};
    }
};

}  // namespace mpm
