/// Isotropic linear elasticity in rate form (hypoelastic; review B.1, equation B.5); in 2D plane strain.
#pragma once
#include <cmath>

#include "lab/math.hpp"

namespace mpm {

/// sigma += lambda tr(D dt) I + 2 mu D dt. In 1D lambda + 2 mu is the modulus of the bar.
struct LinearElastic {
    static constexpr const char* name = "linear";
    double lambda = 0, mu = 0, rho = 1;  // Lame constants [stress], initial density [mass/volume]

    double wave_speed() const { return std::sqrt((lambda + 2 * mu) / rho); }  // P-wave (2.71)

    template <class Point, class Gradient> void update(Point& p, const Gradient& L, double dt) const {
        constexpr int D = Point::D;
        const Mat<D> de = dt * sym<D>(L);
        p.sigma += lambda * de.trace() * identity<D>() + 2 * mu * de;
    }

    /// Stress across the plane, of which the plane strain's trace is tr(sigma)/(2 (lambda + mu)).
    template <class Point> double sigma_zz(const Point& p) const { return lambda / (2 * (lambda + mu)) * p.sigma.trace(); }

    /// Stored energy of a particle, V/2 sigma:eps (6.5), with the strain that belongs to sigma.
    template <class Point> double energy(const Point& p) const {
        constexpr int D = Point::D;
        const double tr = p.sigma.trace();
        return 0.5 * p.V * (contract<D>(p.sigma, p.sigma) - lambda / (D * lambda + 2 * mu) * tr * tr) / (2 * mu);
    }
};

}  // namespace mpm
