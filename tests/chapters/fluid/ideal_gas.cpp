// The ideal gas on given paths: adiabats, energy balance, artificial viscosity.
#include "chapters/fluid/ideal_gas.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/chapters/material/point.hpp"

namespace mpm::test {
namespace {

template <int D> auto gas_at(const IdealGas& law, double rho, double p) {
    auto point = unit_point<D, IdealGas>();
    point.m = rho;
    law.start(point, rho, p);
    return point;
}
/// Compresses or expands evenly to `ratio` of the length in `steps` steps along the first axis.
template <class Point> void stretch(const IdealGas& law, Point& p, double ratio, int steps) {
    Mat<Point::D> G = Mat<Point::D>::Zero();
    G(0, 0) = std::pow(ratio, 1.0 / steps) - 1;
    for (int k = 0; k < steps; ++k) strain(law, p, G);
}

// p rho^-gamma is constant without viscosity: by second order in the step with the mean stress, by first order with that at the end.
TEST(IdealGas, KeepsItsEntropy) {
    const auto error = [](double theta, double ratio, int steps) {
        const IdealGas law{1.4, 0, 0, 1, theta};
        auto p = gas_at<1>(law, 2, 3);
        stretch(law, p, ratio, steps);
        EXPECT_NEAR(p.rho, 2 / ratio, 1e-12);
        return std::abs(-p.sigma(0, 0) / (3 * std::pow(ratio, -1.4)) - 1);
    };
    for (const double ratio : {0.25, 4.0}) {
        EXPECT_NEAR(std::log2(error(0.5, ratio, 100) / error(0.5, ratio, 200)), 2, 0.01);
        EXPECT_NEAR(std::log2(error(1, ratio, 100) / error(1, ratio, 200)), 1, 0.02);
        EXPECT_LT(error(0.5, ratio, 200), 1e-5);
    }
}

// The energy gained is the work of the mean stress on the change of volume, viscous pressure included, in one and two dimensions.
TEST(IdealGas, GainsTheWorkThatIsDone) {
    const IdealGas law{5.0 / 3, 2, 1, 0.3};
    auto line = gas_at<1>(law, 2, 3);
    auto plane = gas_at<2>(law, 2, 3);
    for (const double step : {-0.2, -0.1, 0.3, -0.05}) {
        const double V = line.V, energy = law.energy(line), before = -line.sigma(0, 0);
        strain(law, line, Mat<1>(Mat<1>::Constant(step)));
        strain(law, plane, Mat<2>{{step, 0.7}, {0, 0}});  // shear does no work on a gas
        EXPECT_NEAR(law.energy(line) - energy, -(before - line.sigma(0, 0)) / 2 * (line.V - V), 1e-14);
        EXPECT_NEAR(plane.e, line.e, 1e-14);
        EXPECT_NEAR(plane.sigma(1, 1), line.sigma(0, 0), 1e-13);
        EXPECT_EQ(plane.sigma(0, 1), 0);
    }
}

// (5.35) in compression, with the speed of sound at the start of the step; nothing in expansion.
TEST(IdealGas, ResistsCompressionOnly) {
    const IdealGas law{1.4, 2, 0.5, 0.1};
    auto p = gas_at<1>(law, 1, 1);
    strain(law, p, Mat<1>(Mat<1>::Constant(-0.01)));  // dt = 1
    const double rate = 0.01, a = std::sqrt(1.4), rho = 1 / 0.99;
    EXPECT_NEAR(p.q, rho * 0.1 * (2 * 0.1 * rate * rate + 0.5 * a * rate), 1e-16);
    EXPECT_NEAR(-p.sigma(0, 0), law.pressure(p.rho, p.e) + p.q, 1e-15);
    strain(law, p, Mat<1>(Mat<1>::Constant(0.01)));
    EXPECT_EQ(p.q, 0);
}

// Rankine and Hugoniot: a gas pressed by q alone to rho_2 has the energy of the shock's end, e_2 - e_1 = (p_1 + p_2)/2 (1/rho_1 - 1/rho_2),
// if it is done in one step with the mean stress.
TEST(IdealGas, OneStepIsAShock) {
    const IdealGas law{1.4, 0, 0, 1};
    auto p = gas_at<1>(law, 1, 1);
    const double e1 = p.e;
    strain(law, p, Mat<1>(Mat<1>::Constant(-0.5)));
    const double p2 = -p.sigma(0, 0);
    EXPECT_NEAR(p.e - e1, (1 + p2) / 2 * (1 - 0.5), 1e-14);
    EXPECT_NEAR(p2, (6 * 2 - 1) / (6 - 2.0), 1e-13);  // p2/p1 = (6 r - 1)/(6 - r) for gamma = 1.4, r = rho_2/rho_1
}

TEST(IdealGas, SaysWhenItsEnergyIsGone) {
    const IdealGas law{1.4, 2, 1, 1};
    auto p = gas_at<1>(law, 1, 1);
    EXPECT_FALSE(law.trouble(p));
    strain(law, p, Mat<1>(Mat<1>::Constant(30)));  // the mean stress does more work than there is energy
    EXPECT_EQ(law.trouble(p).cause, "negative-energy");
    const Lattice<1> lattice(Vec<1>(0), Vec<1>(1), {4});
    Matter<1, decltype(p), Node<1>, IdealGas> body{{gas_at<1>(law, 1, 1), p}, Grid<1, Node<1>>(lattice), law};
    const Trouble trouble = check_particles(body);  // so the run ends by this name
    EXPECT_EQ(trouble.cause, "negative-energy");
    EXPECT_EQ(trouble.reason.substr(0, 16), "particle 1 at x ");
}

}  // namespace
}  // namespace mpm::test
