/// The hat function of the standard MPM (review 3.2, equations 3.1 and 3.2).
#pragma once
#include <algorithm>

#include "lab/stencil.hpp"

namespace mpm {

struct Hat {
    static constexpr const char* name = "hat";
    static constexpr int support = 2, min_cells = 1, per_cell = 1;

    AxisWeights<2> operator()(double xi, int cells) const {
        const int cell = std::min(static_cast<int>(xi), cells - 1);  // the last node belongs to the last cell
        const double r = xi - cell;
        return {cell, {1 - r, r}, {-1, 1}};
    }
};

}  // namespace mpm
