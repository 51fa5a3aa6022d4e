// The Newtonian liquid on given paths: closed forms of pressure and viscous stress, energy, a spin that must not swell.
#include "chapters/fluid/newtonian.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/chapters/material/point.hpp"

namespace mpm::test {
namespace {

const Newtonian water{1.2e6, 7, 1000, 3, 0.5};

TEST(Newtonian, PressureFollowsTheEquationOfState) {
    auto p = unit_point<1, Newtonian>();
    const Newtonian still{1.2e6, 7, 1000, 0, 0};
    for (const double step : {-0.01, -0.02, 0.01}) {
        strain(still, p, Mat<1>(Mat<1>::Constant(step)));
        EXPECT_NEAR(p.V, p.F(0, 0), 1e-15);
        EXPECT_NEAR(-p.sigma(0, 0), 1.2e6 * (std::pow(1 / p.V, 7) - 1), 1e-9);
        EXPECT_NEAR(still.pressure(still.volume_ratio(-p.sigma(0, 0))), -p.sigma(0, 0), 1e-8);
    }
}

// (5.29) with lambda_N = zeta - 2/3 mu, by components; across the plane too.
TEST(Newtonian, ViscousStressIsLinearInTheStrainRate) {
    auto p = unit_point<2, Newtonian>();
    const Mat<2> L{{0.02, 0.05}, {-0.01, -0.03}};
    const double dt = 1e-3, lambda = 0.5 - 2.0 / 3 * 3;
    water.update(p, L, dt);
    const double tr = L.trace(), pressure = water.pressure(1 + dt * tr);
    EXPECT_NEAR(p.sigma(0, 0), 2 * 3 * 0.02 + lambda * tr - pressure, 1e-12);
    EXPECT_NEAR(p.sigma(1, 1), 2 * 3 * -0.03 + lambda * tr - pressure, 1e-12);
    EXPECT_NEAR(p.sigma(0, 1), 3 * (0.05 - 0.01), 1e-12);
    EXPECT_NEAR(water.sigma_zz(p), lambda * tr - pressure, 1e-12);
    const Newtonian stokes{1.2e6, 7, 1000, 3, 0};
    auto q = unit_point<2, Newtonian>();
    stokes.update(q, L, dt);
    EXPECT_NEAR(-(q.sigma.trace() + stokes.sigma_zz(q)) / 3, pressure, 1e-9);  // the mean of three axes is p
}

// The stored energy's derivative is the pressure, the work of all stresses what is stored and dissipated.
TEST(Newtonian, BalancesItsWork) {
    auto p = unit_point<2, Newtonian>();
    double work = 0;
    const Mat<2> G{{-1e-5, 2e-4}, {0, -2e-5}};
    for (int k = 0; k < 500; ++k) {
        const Mat<2> before = p.sigma;
        const double V = p.V;
        water.update(p, G, 1);  // dt = 1
        work += (V + p.V) / 2 * contract<2>((before + p.sigma) / 2, sym<2>(G));
    }
    // the middle of a step's volumes against its end: one part in 1e5 of the work
    EXPECT_NEAR(work, water.energy(p) + water.dissipated(p), 3e-5 * work);
    EXPECT_GT(water.dissipated(p), 0);
    const double J = p.J, step = 1e-6;
    const auto stored = [&](double at) {
        p.J = at;
        return water.energy(p);
    };
    EXPECT_NEAR((stored(J + step) - stored(J - step)) / (2 * step), -water.pressure(J), 1e-4 * water.pressure(J));
    EXPECT_NEAR(stored(1 - 1e-9), 0.5 * 7 * 1.2e6 * 1e-18, 1e-16);  // no loss of digits near J = 1
}

// det(I + dt L) grows by (dt omega)^2 each step of a spin; the density must not.
TEST(Newtonian, DoesNotSwellInASpin) {
    auto p = unit_point<2, Newtonian>();
    const Mat<2> spin{{0, -0.01}, {0.01, 0}};
    for (int k = 0; k < 10000; ++k) {
        p.F += spin * p.F;
        p.V = p.F.determinant();
        water.update(p, spin, 1);
    }
    EXPECT_GT(p.F.determinant(), 2.7);  // e
    EXPECT_EQ(p.V, 1);
    EXPECT_EQ(p.sigma, Mat<2>(Mat<2>::Zero()));
}

// sqrt(gamma kappa/rho), and more under pressure: dp/drho by differences.
TEST(Newtonian, SoundSpeedIsTheSlopeOfItsPressure) {
    for (const double p : {0.0, 1e5, 1e7}) {
        const double J = water.volume_ratio(p), step = 1e-6 * J;
        const double dp = water.pressure(J - step) - water.pressure(J + step), drho = 1000 / (J - step) - 1000 / (J + step);
        EXPECT_NEAR(water.wave_speed(p), std::sqrt(dp / drho), 1e-8 * water.wave_speed(p));
    }
    EXPECT_NEAR(water.wave_speed(), std::sqrt(7 * 1200.0), 1e-12);
    EXPECT_GT(water.signal_speed(10, 0.1), 10);
}

}  // namespace
}  // namespace mpm::test
