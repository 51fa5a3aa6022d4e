/// The contiguous-particle GIMP function (review 3.3.2, equations 3.11 and 3.14): the domain stretches with F along the axes.
#pragma once
#include <algorithm>
#include <string>

#include "lab/stencil.hpp"

namespace mpm {

/// A particle's domain is longer than its weighting function covers, or not positive (its F has turned inside out).
struct DomainTooLong : OutsideGrid {
    using OutsideGrid::OutsideGrid;
};

namespace detail {
[[noreturn, gnu::cold, gnu::noinline]] inline void domain_too_long(const char* shape, double l, int most) {
    throw DomainTooLong("a particle domain " + std::to_string(l) + " cells long: " + shape + " takes more than 0 and at most " +
                        std::to_string(most));
}
/// Throws unless 0 < l <= most; also catches nan.
inline void check_domain(const char* shape, double l, int most) {
    if (!(l > 0 && l <= most)) [[unlikely]]
        domain_too_long(shape, l, most);
}
}  // namespace detail

/// The mean over the domain of the line through c_0 and c_1 of the particle's cell, plus what the kinks at the cell's two ends
/// add where the domain reaches past them: for a reach a, a^2/(2l) (c_-1 - 2 c_0 + c_1). It equals [G(x+l/2) - G(x-l/2)]/l, with
/// G the antiderivative of the hat, but loses no digits for small l. An end of the grid has no kink: there c_-1 = 2 c_0 - c_1.
struct Cpgimp {
    static constexpr const char* name = "cpgimp";
    static constexpr int support = 4, min_cells = 3, per_cell = 1;

    double l0 = 1;  // initial size of a particle domain [cells]

    template <class Point> double size(const Point& p, int axis) const { return l0 * p.F(axis, axis); }

    AxisWeights<4> operator()(double xi, int cells, double l) const {
        detail::check_domain(name, l, 2);
        const int cell = std::min(static_cast<int>(xi), cells - 1);
        const double r = xi - cell, q = 1 - r;
        const double a = cell > 0 ? std::max(0.0, l / 2 - r) : 0;          // reach past the cell's lower end
        const double b = cell < cells - 1 ? std::max(0.0, l / 2 - q) : 0;  // and its upper end
        const double A = a * (a / l) / 2, B = b * (b / l) / 2, dA = -a / l, dB = b / l;
        if (cell == 0) return {0, {q + B, r - 2 * B, B, 0}, {-1 + dB, 1 - 2 * dB, dB, 0}};
        if (cell == cells - 1) return {cells - 3, {0, A, q - 2 * A, r + A}, {0, dA, -1 - 2 * dA, 1 + dA}};
        return {cell - 1, {A, q - 2 * A + B, r + A - 2 * B, B}, {dA, -1 - 2 * dA + dB, 1 + dA - 2 * dB, dB}};
    }
};

}  // namespace mpm
