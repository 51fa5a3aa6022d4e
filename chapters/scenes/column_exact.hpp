/// What the column must do: its state of rest under a load, for any elastic law, and its vibration under a step load (report equation 70).
#pragma once
#include <cmath>
#include <cstddef>
#include <string>

#include "lab/fill.hpp"
#include "lab/math.hpp"
#include "lab/options.hpp"

namespace mpm {

/// Just what a law reads and writes.
struct Stretched {
    static constexpr int D = 1;
    double V0 = 1;
    Mat<1> F = identity<1>(), sigma = Mat<1>::Zero();
};

/// The first Piola-Kirchhoff stress at a stretch F = 1 + du/dX (the report's equations 6 and 45 have - 1; below 66 it must say J^2 = det
/// C); in one dimension it is the Cauchy stress, since J F^-1 = 1.
template <class Law>
double piola_stress(const Law& law, double F) {
    Stretched p;
    p.F(0, 0) = F;
    law.update(p, Mat<1>(Mat<1>::Zero()), 0);
    return p.sigma(0, 0);
}

/// dP/dF by a central difference, to ten digits.
template <class Law>
double stiffness(const Law& law, double F) {
    const double step = 1e-5 * F;
    return (piola_stress(law, F + step) - piola_stress(law, F - step)) / (2 * step);
}

/// The stretch F at which P(F) = P, by bisection of ln F. Throws BadInput if the law has none.
template <class Law>
double stretch(const Law& law, double P) {
    const auto too_small = [&](double lnF) { return piola_stress(law, std::exp(lnF)) < P; };
    double low = -1, high = 1;
    while (low > -100 && !too_small(low)) low *= 2;
    while (high < 100 && too_small(high)) high *= 2;
    if (!too_small(low) || too_small(high)) throw BadInput("--traction, --gravity: the law cannot carry a stress of " + std::to_string(P));
    while (true) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) return std::exp(middle);
        (too_small(middle) ? low : high) = middle;
    }
}

/// A column 0 < X < L at rest, fixed at X = 0, under a traction at X = L and a body force b per mass: dP/dX + rho b = 0 gives P.
template <class Law>
struct ColumnAtRest {
    const Law& law;
    double length, traction, body_force;  // b [force/volume], here rho b

    double stress(double X) const { return traction + body_force * (length - X); }
    double F(double X) const { return stretch(law, stress(X)); }
    /// u(X), the integral of F - 1 from the fixed end, by Gauss points: F is smooth.
    double displacement(double X) const {
        static const CellRule rule = gauss_points(12);
        double u = 0;
        for (std::size_t q = 0; q < rule.at.size(); ++q) u += rule.part[q] * X * (F(rule.at[q] * X) - 1);
        return u;
    }
};

/// Displacement at X of a linear bar, fixed at X = 0, under a traction that sets in at t = 0: `strain` = traction/modulus, wave speed c.
/// The series (70), 8 L strain/pi^2 sum (-1)^(n-1)/(2n-1)^2 sin(k_n X) [1 - cos(k_n c t)] with k_n = (2n-1) pi/(2L), summed: by sin a cos b
/// = [sin(a + b) + sin(a - b)]/2 each part is the series of the triangle wave T with T(y) = y for |y| <= L and T(y + 2L) = -T(y).
inline double step_loaded(double X, double ct, double length, double strain) {
    const auto triangle = [length](double y) { return length - std::abs(std::remainder(y - length, 4 * length)); };
    return strain * (triangle(X) - (triangle(X + ct) + triangle(X - ct)) / 2);
}

}  // namespace mpm
