/// The quadratic Bernstein functions (review 3.5, equations 3.24 and 3.25), nodes at the ends and the middle of each cell.
#pragma once
#include <algorithm>

#include "lab/stencil.hpp"

namespace mpm {

/// Only C0 across cells: for total-Lagrangian schemes, whose particles never cross one.
struct Bernstein {
    static constexpr const char* name = "bernstein";
    static constexpr int support = 3, min_cells = 1, per_cell = 2;

    AxisWeights<3> operator()(double xi, int cells) const {
        const int cell = std::min(static_cast<int>(xi), cells - 1);
        const double r = xi - cell, q = 1 - r;
        return {2 * cell, {q * q, 2 * r * q, r * r}, {-2 * q, 2 * (q - r), 2 * r}};
    }
};

}  // namespace mpm
