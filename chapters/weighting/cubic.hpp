/// The cubic B-spline of a grid with as many functions as nodes (review 3.4, equations 3.18 to 3.21).
#pragma once
#include <algorithm>

#include "lab/stencil.hpp"

namespace mpm {

/// Written cell by cell: an inner cell sees four functions, a cell at an end of the grid three, whose fourth
/// was folded by c_-1 = 2 c_0 - c_1. This gives the review's types 1 to 4, with no difference of near-equal numbers.
struct Cubic {
    static constexpr const char* name = "cubic";
    static constexpr int support = 4, min_cells = 3, per_cell = 1;

    AxisWeights<4> operator()(double xi, int cells) const {
        const int cell = std::min(static_cast<int>(xi), cells - 1);
        const double r = xi - cell, q = 1 - r, r2 = r * r, q2 = q * q, r3 = r2 * r / 6, q3 = q2 * q / 6;
        if (cell == 0) return {0, {q + r3, r - 2 * r3, r3, 0}, {r2 / 2 - 1, 1 - r2, r2 / 2, 0}};
        if (cell == cells - 1) return {cells - 3, {0, q3, q - 2 * q3, r + q3}, {0, -q2 / 2, q2 - 1, 1 - q2 / 2}};
        return {cell - 1,
                {q3, 2.0 / 3 - r2 + 3 * r3, 2.0 / 3 - q2 + 3 * q3, r3},
                {-q2 / 2, r * (1.5 * r - 2), q * (2 - 1.5 * q), r2 / 2}};
    }
};

}  // namespace mpm
