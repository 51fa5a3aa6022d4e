/// Newmark's rule at the particles (Aulisa and Capodaglio, equations 17 to 19 and 21): displacements come from the grid, velocities and
/// accelerations stay with the particles, nothing is mapped to the nodes. In (19) and (21) u is the increment of the step.
///
/// `theta` says where in the step forces act: 1, at its end, is the published method. The midpoint rule of Love and Sulsky (2006) is beta =
/// 1/2, gamma = 1, theta = 1/2: (21) then asks for no old acceleration, and none is carried.
#pragma once
#include <cmath>

#include "lab/math.hpp"

namespace mpm {

struct Newmark {
    double beta = 0.25, gamma = 0.5, theta = 1;  // [-]

    static Newmark midpoint() { return {0.5, 1, 0.5}; }

    /// da/du [1/time^2]
    double inertia(double dt) const { return 1 / (beta * dt * dt); }
    /// (21): what does not depend on u.
    template <class Point> auto known(const Point& p, double dt) const {
        return Vec<Point::D>(p.v / (beta * dt) + (1 - 2 * beta) / (2 * beta) * p.a);
    }
    /// (17) and (19) after the step: u is the particle's displacement in it.
    template <class Point> void finish(Point& p, const Vec<Point::D>& u, double dt) const {
        const Vec<Point::D> a = inertia(dt) * u - known(p, dt);
        p.v += dt * ((1 - gamma) * p.a + gamma * a);
        p.a = a;
    }

    /// The phase that the rule with gamma = 1/2 (or the midpoint rule) gives a vibration of frequency omega in one step: cos(phase) = 1 -
    /// Om^2/2/(1 + beta Om^2) with Om = omega dt; the midpoint rule has that of beta = 1/4.
    double phase(double omega, double dt) const {
        const double Om2 = omega * omega * dt * dt, b = theta < 1 ? 0.25 : beta;
        return std::acos(1 - Om2 / 2 / (1 + b * Om2));
    }
};

}  // namespace mpm
