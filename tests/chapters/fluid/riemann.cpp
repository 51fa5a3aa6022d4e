// The exact Riemann solver: printed solutions, jump conditions, invariants across rarefactions, symmetry, vacuum.
#include "chapters/fluid/riemann.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mpm::test {
namespace {

constexpr double gamma = 1.4;
struct Problem {
    GasState left, right;
    double p, u, rho_left, rho_right;  // between the waves, as Toro prints them (table 4.3), 6 digits
};
const std::vector<Problem> toro{{{1, 0, 1}, {0.125, 0, 0.1}, 0.30313, 0.92745, 0.42632, 0.26557},
                                {{1, -2, 0.4}, {1, 2, 0.4}, 0.00189, 0.00000, 0.02185, 0.02185},
                                {{1, 0, 1000}, {1, 0, 0.01}, 460.894, 19.5975, 0.57506, 5.99924},
                                {{1, 0, 0.01}, {1, 0, 100}, 46.0950, -6.19633, 5.99242, 0.57511},
                                {{5.99924, 19.5975, 460.894}, {5.99242, -6.19633, 46.0950}, 1691.64, 8.68975, 14.2823, 31.0426}};

TEST(Riemann, HasToresPrintedSolutions) {
    for (const Problem& problem : toro) {
        const Riemann r(problem.left, problem.right, gamma);
        const double digit = 6e-6;  // of the print, relative; states of 6e-3 and below are printed to 5 decimals
        EXPECT_NEAR(r.p_star(), problem.p, digit * std::max(1.0, problem.p));
        EXPECT_NEAR(r.u_star(), problem.u, digit * std::max(1.0, std::abs(problem.u)));
        EXPECT_NEAR(r.rho_left(), problem.rho_left, digit * std::max(1.0, problem.rho_left));
        EXPECT_NEAR(r.rho_right(), problem.rho_right, digit * std::max(1.0, problem.rho_right));
    }
    EXPECT_NEAR(Riemann(toro[0].left, toro[0].right, gamma).last(), 1.75216, 5e-6);  // NUMBERS section 7
}

// Mass, momentum and energy in a moving box that holds all waves change by the fluxes of the states outside: the integral form.
TEST(Riemann, ConservesMassMomentumAndEnergy) {
    for (const Problem& problem : toro) {
        const Riemann r(problem.left, problem.right, gamma);
        const double a = r.first() - 1, b = r.last() + 1;
        const int n = 400000;
        std::vector<double> sum(3, 0.0);
        const auto conserved = [&](const GasState& s) {
            return std::vector<double>{s.rho, s.rho * s.u, s.rho * (s.energy(gamma) + s.u * s.u / 2)};
        };
        for (int i = 0; i < n; ++i) {
            const auto U = conserved(r.at(a + (i + 0.5) * (b - a) / n));
            for (std::size_t k = 0; k < 3; ++k) sum[k] += U[k] * (b - a) / n;
        }
        const auto left = conserved(problem.left), right = conserved(problem.right);
        const auto flux = [](const GasState& s, const std::vector<double>& U) {
            return std::vector<double>{U[1], U[1] * s.u + s.p, (U[2] + s.p) * s.u};
        };
        const auto in = flux(problem.left, left), out = flux(problem.right, right);
        for (std::size_t k = 0; k < 3; ++k) {
            const double exact = b * right[k] - a * left[k] + in[k] - out[k];
            const double scale = std::abs(b * right[k]) + std::abs(a * left[k]) + std::abs(in[k]) + std::abs(out[k]) + 1e-3;
            EXPECT_NEAR(sum[k], exact, 3e-5 * scale);  // jumps within a cell of the sum
        }
    }
}

TEST(Riemann, IsItsOwnMirrorImageAndMovesWithTheFrame) {
    for (const Problem& problem : toro) {
        const auto mirror = [](const GasState& s) { return GasState{s.rho, -s.u, s.p}; };
        const auto moved = [](const GasState& s) { return GasState{s.rho, s.u + 3, s.p}; };
        const Riemann r(problem.left, problem.right, gamma), back(mirror(problem.right), mirror(problem.left), gamma),
            faster(moved(problem.left), moved(problem.right), gamma);
        for (double xi = r.first() - 0.5; xi < r.last() + 0.5; xi += 0.0317) {
            const GasState s = r.at(xi), m = back.at(-xi), f = faster.at(xi + 3);
            EXPECT_NEAR(s.rho, m.rho, 1e-9 * s.rho);
            EXPECT_NEAR(s.u, -m.u, 1e-9 * (1 + std::abs(s.u)));
            EXPECT_NEAR(s.p, f.p, 1e-9 * s.p);
            EXPECT_NEAR(s.u + 3, f.u, 1e-9 * (1 + std::abs(s.u)));
        }
    }
}

// p/rho^gamma and u + 2 c/(gamma - 1) stay what they were through the fan, whose end, the escaping front, has the velocity of the latter.
TEST(Riemann, ExpandsIntoVacuumByTheRiemannInvariants) {
    const GasState gas{2, 0.3, 5};
    const double c = gas.sound_speed(gamma), front = gas.u + 2 * c / (gamma - 1);
    for (const Riemann& r : {Riemann(gas, {0, 0, 0}, gamma), Riemann(gas, {1, front + 60, 1}, gamma)}) {
        EXPECT_TRUE(r.vacuum());
        for (double xi = gas.u - c - 0.2; xi < front; xi += 0.01) {
            const GasState s = r.at(xi);
            EXPECT_NEAR(s.p / std::pow(s.rho, gamma), gas.p / std::pow(gas.rho, gamma), 1e-9);
            EXPECT_NEAR(s.u + 2 * s.sound_speed(gamma) / (gamma - 1), front, 1e-9);
        }
        EXPECT_EQ(r.at(front + 1e-6).rho, 0);
        EXPECT_EQ(r.p_star(), 0);
    }
    EXPECT_NEAR(Riemann({0, 0, 0}, gas, gamma).first(), gas.u - 2 * c / (gamma - 1), 1e-12);
}

// Limits of states: equal ones give no waves, weak ones the acoustic solution, a pressure of zero is no division by zero.
TEST(Riemann, HasTheRightLimits) {
    const GasState gas{1.3, 0.4, 2};
    const Riemann still(gas, gas, gamma);
    EXPECT_NEAR(still.p_star(), gas.p, 1e-14);
    EXPECT_NEAR(still.at(0.4).rho, gas.rho, 1e-14);
    const double c = gas.sound_speed(gamma), step = 1e-6;
    EXPECT_NEAR(Riemann(gas, {gas.rho, gas.u, gas.p + step}, gamma).u_star(), gas.u - step / (2 * gas.rho * c), 1e-12);
    const Riemann cold({1, 1, 0}, {1, -1, 0}, gamma);  // shocks of infinite strength: density 6 times, p = rho (gamma + 1)/2 v^2
    EXPECT_NEAR(cold.p_star(), 1.2, 1e-14);
    EXPECT_NEAR(cold.rho_left(), 6, 1e-12);
}

}  // namespace
}  // namespace mpm::test
