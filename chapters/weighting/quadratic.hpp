/// The quadratic B-spline with its nodes on the grid lines (review 3.4, equations 3.15 and 3.16 for k = 2).
#pragma once
#include "lab/stencil.hpp"

namespace mpm {

/// Knots lie midway between nodes. In the half cell at an end of the grid, c_-1 = 2 c_0 - c_1 leaves the hat.
struct Quadratic {
    static constexpr const char* name = "quadratic";
    static constexpr int support = 3, min_cells = 2, per_cell = 1;

    AxisWeights<3> operator()(double xi, int cells) const {
        const int node = static_cast<int>(xi + 0.5);  // the nearest
        const double s = xi - node, a = 0.5 - s, b = 0.5 + s;
        if (node == 0) return {0, {1 - s, s, 0}, {-1, 1, 0}};
        if (node >= cells) return {cells - 2, {0, cells - xi, 1 - (cells - xi)}, {0, -1, 1}};
        return {node - 1, {a * a / 2, 0.75 - s * s, b * b / 2}, {-a, -2 * s, b}};
    }
};

}  // namespace mpm
