/// What happens across the plane (or, in 1D, the line): nothing, unless a particle says so.
#pragma once
#include <cmath>

namespace mpm {

/// Stretch along each axis that the problem does not have: that of the particle, where it has one (F-bar: review 5.2), else 1.
template <class Point> double stretch_across(const Point& p) {
    if constexpr (requires { p.F33; })
        return p.F33;
    else
        return 1;
}
/// det F of all three axes.
template <class Point> double volume_ratio(const Point& p) {
    const double J = p.F.determinant();
    if constexpr (!requires { p.F33; })
        return J;
    else
        return Point::D == 1 ? J * p.F33 * p.F33 : J * p.F33;
}

}  // namespace mpm
