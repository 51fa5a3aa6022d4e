/// Ideal gas with artificial viscosity (review 5.4.2, equations 5.32 to 5.35): the pressure follows from density and specific internal
/// energy, and the energy is a history of the particle. One law for one and two dimensions.
#pragma once
#include <array>
#include <cmath>
#include <string>

#include "lab/math.hpp"
#include "lab/monitor.hpp"

namespace mpm {

/// sigma = -(p + q) I, p = (gamma - 1) rho e.
///
/// Mended: the increments of (5.33) and (5.34) already hold dt, so the printed factor dt goes; and the work is that of the change of 1/rho,
/// so that (5.33) divides by the density at t. The volume is m/rho, not det F V0 (newtonian.hpp tells why). The coefficients of (5.35) are
/// c0 and c1. The work takes the mean of the stresses at t and t + dt: forces at t meet the velocities half a step before and after, and so
/// the kinetic energy loses just what the internal energy gains. With the stress at t + dt alone, as printed, the sum drifts with dt.
struct IdealGas {
    static constexpr const char* name = "ideal-gas";
    static constexpr std::array<const char*, 4> columns{"rho", "p", "e", "q"};  // of snapshots
    template <class Base> struct PointOf : Base {
        double rho = 0, e = 0, q = 0;  // density, specific internal energy [energy/mass], viscous pressure
    };

    double gamma = 1.4;       // ratio of specific heats [-]
    double c0 = 0, c1 = 0;    // quadratic and linear artificial viscosity [-]; 0: none
    double Le = 0;            // shortest side of a cell [length]
    double theta = 0.5;       // share of the stress at t + dt in the work: 1/2 centred, 1 as printed

    double pressure(double rho, double e) const { return (gamma - 1) * rho * e; }
    double sound_speed(double rho, double p) const { return rho > 0 && p > 0 ? std::sqrt(gamma * p / rho) : 0; }

    /// What h/dt must exceed where the velocity jumps by `jump` from cell to cell: the artificial viscosity is a diffusion of
    /// Le (c1 c + c0 jump), and the leapfrog of a damped wave needs dt < h/(Q + sqrt(Q^2 + c^2)).
    double signal_speed(double c, double jump) const {
        const double Q = c1 * c + c0 * jump;
        return Q + std::sqrt(Q * Q + c * c);
    }

    /// Puts a particle of mass m and volume V into a state.
    template <class Point> void start(Point& p, double rho, double pressure) const {
        p.rho = rho;
        p.e = pressure / ((gamma - 1) * rho);
        p.sigma = Mat<Point::D>(-pressure * identity<Point::D>());
    }

    /// Sets the volume too.
    template <class Point, class Gradient> void update(Point& p, const Gradient& L, double dt) const {
        const double before = -p.sigma(0, 0), rate = L.trace(), change = dt * rate / p.rho;  // of 1/rho
        const double a = sound_speed(1, (gamma - 1) * p.e);
        p.rho /= 1 + dt * rate;                                                              // (5.34)
        p.V = p.m / p.rho;
        p.q = rate < 0 ? p.rho * Le * (c0 * Le * rate * rate - c1 * a * rate) : 0;           // (5.35)
        p.e = (p.e - ((1 - theta) * before + theta * p.q) * change) / (1 + theta * (gamma - 1) * p.rho * change);  // (5.33)
        p.sigma = Mat<Point::D>(-(pressure(p.rho, p.e) + p.q) * identity<Point::D>());       // (5.32)
    }

    template <class Point> double sigma_zz(const Point& p) const { return p.sigma(0, 0); }
    /// Internal energy of a particle.
    template <class Point> double energy(const Point& p) const { return p.m * p.e; }
    template <class Point> std::array<double, 4> values(const Point& p) const { return {p.rho, pressure(p.rho, p.e), p.e, p.q}; }

    /// A gas below absolute zero has no speed of sound: the work of a step was more than a particle had.
    template <class Point> Trouble trouble(const Point& p) const {
        if (p.e >= 0) return {};
        return {"negative-energy", "has the specific internal energy e = " + std::to_string(p.e)};
    }
};

}  // namespace mpm
