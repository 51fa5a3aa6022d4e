/// The unchanged GIMP function (review 3.3.1, equations 3.12 and 3.13): every particle keeps its initial size.
#pragma once
#include <algorithm>
#include <cmath>

#include "chapters/weighting/cpgimp.hpp"

namespace mpm {

struct Ugimp {
    static constexpr const char* name = "ugimp";
    static constexpr int support = 3, min_cells = 2, per_cell = 1;

    double l = 1;  // size of a particle domain [cells], at most 1

    template <class Point> double size(const Point&, int) const { return l; }

    /// A domain no longer than a cell reaches past one node at most, the nearest: the hat, and a kink there as in Cpgimp.
    AxisWeights<3> operator()(double xi, int cells, double length) const {
        detail::check_domain(name, length, 1);
        const int node = static_cast<int>(xi + 0.5);
        const double s = xi - node, side = s < 0 ? -1 : 1, left = std::max(0.0, -s), right = std::max(0.0, s);
        if (node == 0) return {0, {1 - s, s, 0}, {-1, 1, 0}};  // an end of the grid has no kink
        if (node >= cells) return {cells - 2, {0, cells - xi, 1 - (cells - xi)}, {0, -1, 1}};
        const double a = std::max(0.0, length / 2 - std::abs(s)), A = a * (a / length) / 2, dA = -side * a / length;
        return {node - 1,
                {A + left, 1 - std::abs(s) - 2 * A, A + right},
                {dA - (s < 0 ? 1 : 0), -side - 2 * dA, dA + (s < 0 ? 0 : 1)}};
    }
};

}  // namespace mpm
