/// Weakly compressible Newtonian liquid (review 5.4.1, equations 5.29 to 5.31): viscous stress from the strain rate, pressure from an
/// equation of state. One law for one and two dimensions (plane flow).
#pragma once
#include <cmath>

#include "lab/math.hpp"

namespace mpm {

/// sigma = 2 mu dev(D) + zeta tr(D) I - p I, p = kappa (J^-gamma - 1), J = rho0/rho.
///
/// Mended: Stokes' condition is lambda_N = -2/3 mu_N, which is zeta = lambda_N + 2/3 mu_N = 0; and the speed of sound is
/// sqrt(gamma kappa/rho), 2.6 times the printed sqrt(kappa/rho) for water. dev(D) has the third axis, so that the pressure of three axes is
/// p where zeta = 0. J follows tr(L), as the density in (5.34): det(I + dt L) grows by dt^2 omega^2 in every step of a spin, and water in a
/// long-lived eddy would swell.
struct Newtonian {
    static constexpr const char* name = "newtonian";
    template <class Base> struct PointOf : Base {
        double p = 0, viscous33 = 0;  // pressure of the equation of state, viscous stress across the plane
        double viscous_work = 0;      // dissipated energy of the particle
        double J = 1;                 // rho0/rho by the divergence of the flow [-]
    };

    double kappa = 1.2e6, gamma = 7, rho = 1000;  // bulk modulus [stress], exponent [-], density at rest [mass/volume]
    double mu = 1e-3, zeta = 0;                   // viscosities of shear and of volume [stress time]

    double pressure(double J) const { return kappa * (std::pow(J, -gamma) - 1); }
    /// J under a pressure above -kappa.
    double volume_ratio(double p) const { return std::pow(1 + p / kappa, -1 / gamma); }
    /// Speed of sound under a pressure.
    double wave_speed(double p = 0) const { return std::sqrt(gamma * kappa / rho) * std::pow(volume_ratio(p), (1 - gamma) / 2); }

    /// What h/dt must exceed where sound goes with c: viscosity is a diffusion of nu = (4/3 mu + zeta)/rho, along both axes at once, and
    /// the leapfrog of a damped wave needs dt < h/(Q + sqrt(Q^2 + c^2)) with Q = 2 nu/h.
    double signal_speed(double c, double h) const {
        const double Q = 2 * (4 * mu / 3 + zeta) / (rho * h);
        return Q + std::sqrt(Q * Q + c * c);
    }

    /// Puts a particle at rest under a pressure; its F is to be that of J.
    template <class Point> void start(Point& point, double p) const {
        point.p = p;
        point.J = volume_ratio(p);
        point.V = point.J * point.V0;
        point.sigma = Mat<Point::D>(-p * identity<Point::D>());
    }

    /// Sets the volume too. The viscous work takes the mean of the stresses at t and t + dt, as forces do theirs (ideal_gas.hpp).
    template <class Point, class Gradient> void update(Point& point, const Gradient& L, double dt) const {
        constexpr int D = Point::D;
        const Mat<D> rate = sym<D>(L), before = point.sigma + point.p * identity<D>();
        const double across = (zeta - 2 * mu / 3) * rate.trace();
        const Mat<D> viscous = 2 * mu * rate + across * identity<D>();                       // (5.29), (5.30)
        point.J *= 1 + dt * rate.trace();                                                    // (5.34)
        point.V = point.J * point.V0;
        point.p = pressure(point.J);                                                         // (5.31)
        point.sigma = viscous - point.p * identity<D>();
        point.viscous33 = across;
        point.viscous_work += dt * point.V * contract<D>((before + viscous) / 2, rate);
    }

    template <class Point> double sigma_zz(const Point& point) const { return point.viscous33 - point.p; }
    /// Stored energy of a particle, V0 kappa [(J^(1 - gamma) - 1)/(gamma - 1) + J - 1], whose derivative by J is -p. gamma > 1.
    template <class Point> double energy(const Point& point) const {
        const double J = point.J;
        return point.V0 * kappa * (std::expm1((1 - gamma) * std::log(J)) / (gamma - 1) + (J - 1));
    }
    template <class Point> double dissipated(const Point& point) const { return point.viscous_work; }
};

}  // namespace mpm
