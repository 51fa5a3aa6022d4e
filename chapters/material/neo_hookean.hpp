/// Compressible neo-Hookean solid (review B.2, equations B.6 and B.7); in 2D plane strain (F33 = 1, or that of
/// the particle).
#pragma once
#include <cmath>

#include "chapters/material/across.hpp"
#include "lab/math.hpp"

namespace mpm {

/// sigma = [mu (F F^T - I) + lambda ln J I] / J.
struct NeoHookean {
    static constexpr const char* name = "neo-hookean";
    double lambda = 0, mu = 0, rho = 1;  // Lame constants [stress], initial density [mass/volume]

    double wave_speed() const { return std::sqrt((lambda + 2 * mu) / rho); }  // P-wave of the undeformed solid (2.71)

    template <class Point, class Gradient> void update(Point& p, const Gradient&, double) const {
        constexpr int D = Point::D;
        const double J = volume_ratio(p);
        p.sigma = (mu * (p.F * p.F.transpose() - identity<D>()) + lambda * std::log(J) * identity<D>()) / J;
    }

    template <class Point> double sigma_zz(const Point& p) const {
        const double J = volume_ratio(p), F33 = stretch_across(p);
        return (mu * (F33 * F33 - 1) + lambda * std::log(J)) / J;
    }

    /// Stored energy of a particle, V0 [mu/2 (tr F F^T - 3) - mu ln J + lambda/2 (ln J)^2], whose derivative is (B.6).
    template <class Point> double energy(const Point& p) const {
        const double lnJ = std::log(volume_ratio(p)), F33 = stretch_across(p);
        const double across = (3 - Point::D) * (F33 * F33 - 1);
        return p.V0 * (0.5 * mu * (p.F.squaredNorm() - Point::D + across) - mu * lnJ + 0.5 * lambda * lnJ * lnJ);
    }
};

}  // namespace mpm
