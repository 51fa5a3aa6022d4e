/// Linear elasticity in rate form with thermal expansion (review 5.26).
#pragma once
#include "chapters/material/linear_elastic.hpp"

namespace mpm {

/// The elastic part of a strain increment is what is left of it without the expansion alpha (T - T of the last update) along each of the D
/// axes. Across them the solid expands as it likes; one that is held there (plane strain) has the same stress in the plane with
/// (1 + nu) alpha, since (3 lambda + 2 mu) alpha = (2 lambda + 2 mu) (1 + nu) alpha.
struct ThermoElastic : LinearElastic {
    static constexpr const char* name = "thermo-elastic";
    template <class Base> struct PointOf : Base {
        double T_stress = 0;        // temperature that the stress belongs to
        double expansion_work = 0;  // work of the stress on the expansion [energy]
    };
    double alpha = 0;  // linear expansion [1/temperature]

    template <class Point, class Gradient> void update(Point& p, const Gradient& L, double dt) const {
        constexpr int D = Point::D;
        const double expansion = alpha * (p.T - p.T_stress), before = p.sigma.trace();
        LinearElastic::update(p, L, dt);
        p.sigma -= (D * lambda + 2 * mu) * expansion * identity<D>();
        p.T_stress = p.T;
        p.expansion_work += p.V * expansion * (before + p.sigma.trace()) / 2;
    }
    /// Mechanical energy that expansion has turned into heat; below zero where heat has done work. The temperature does not feel it.
    template <class Point> double dissipated(const Point& p) const { return p.expansion_work; }
};

}  // namespace mpm
