/// One material point driven along a strain path, for the tests of the laws.
#pragma once
#include "chapters/explicit/point.hpp"
#include "lab/body.hpp"

namespace mpm::test {

/// A particle of unit volume with the history that a law needs.
template <int D, class Law> auto unit_point() {
    typename WithHistory<Law, Point<D>>::Point p;
    p.m = p.V0 = p.V = 1;
    return p;
}

/// One step with the displacement gradient G on the positions at its start, as updated-Lagrangian schemes do it. Returns the work of the
/// stress on the strain of the step, with means over the step.
template <class Law, class Point, class Gradient> double strain(const Law& law, Point& p, const Gradient& G) {
    constexpr int D = Point::D;
    const Mat<D> before = p.sigma, mid = G * (identity<D>() + 0.5 * G).inverse();
    const double V = p.V;
    p.F += G * p.F;
    p.V = p.F.determinant() * p.V0;
    law.update(p, G, 1);
    return 0.25 * (V + p.V) * contract<D>(before + p.sigma, sym<D>(mid));
}

}  // namespace mpm::test
