/// Hooke's law between the first Piola-Kirchhoff stress and the displacement gradient: linear elasticity on the initial configuration.
#pragma once
#include <cmath>

#include "chapters/material/across.hpp"
#include "lab/math.hpp"

namespace mpm {

/// P = lambda tr(e) I + 2 mu e with e = sym(F - I), kept as sigma = P F^T/J. Small displacements; a total-Lagrangian bar with this law solves
/// the linear wave equation, to which its exact solutions belong (the rate form gives E ln F there, whose even part moves the mean).
struct Hooke {
    static constexpr const char* name = "hooke";
    double lambda = 0, mu = 0, rho = 1;  // Lame constants [stress], initial density [mass/volume]

    double wave_speed() const { return std::sqrt((lambda + 2 * mu) / rho); }  // P-wave (2.71)

    template <class Point, class Gradient> void update(Point& p, const Gradient&, double) const {
        constexpr int D = Point::D;
        const Mat<D> e = sym<D>(p.F - identity<D>());
        const double trace = e.trace() + (3 - D) * (stretch_across(p) - 1);
        const Mat<D> P = lambda * trace * identity<D>() + 2 * mu * e;
        p.sigma = P * p.F.transpose() / volume_ratio(p);
    }

    /// Stress across the plane, P33 F33/J.
    template <class Point> double sigma_zz(const Point& p) const {
        const double e33 = stretch_across(p) - 1;
        return (lambda * (p.F.trace() - Point::D + e33) + 2 * mu * e33) * (1 + e33) / volume_ratio(p);
    }

    /// Stored energy of a particle, V0 [lambda/2 tr(e)^2 + mu e:e].
    template <class Point> double energy(const Point& p) const {
        constexpr int D = Point::D;
        const Mat<D> e = sym<D>(p.F - identity<D>());
        const double e33 = stretch_across(p) - 1, trace = e.trace() + (3 - D) * e33;
        return p.V0 * (0.5 * lambda * trace * trace + mu * (contract<D>(e, e) + (3 - D) * e33 * e33));
    }
};

}  // namespace mpm
