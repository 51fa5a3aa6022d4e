// The bar of review 6.1.1 by finite elements: closed-form frequencies, energy.
#include <gtest/gtest.h>

#include <numbers>

#include "chapters/fem/total.hpp"
#include "chapters/fem/updated.hpp"
#include "chapters/scenes/bar.hpp"
#include "chapters/weighting/assemble_with.hpp"

namespace mpm::test {
namespace {

struct Outcome {
    double frequency, energy;  // against the exact one - 1; last period over first
};
template <class Scheme, class Kernel = Hat> Outcome vibrate(int cells, int gauss, int mode, double t_end = 40) {
    Bar<true> bar;
    bar.mode = mode;
    bar.placing = "gauss";
    Common common;
    common.ppc = gauss;
    common.t_end = t_end;
    const Assembled a = assemble_with<Kernel, true>(Scheme{}, bar, NoTransfer{}, cells, common);
    const int steps = static_cast<int>(std::ceil(t_end / (0.1 * bar.cell_size(cells) / 10) - 1e-9));  // dt = 0.1 h/c, c = 10
    const double dt = t_end / steps;
    a.simulation.sample(0, a.simulation.measure().total());
    for (int k = 1; k <= steps; ++k) {
        a.simulation.step((k - 1) * dt, dt);
        a.simulation.sample(k * dt, a.simulation.measure().total());
    }
    return {a.facts(t_end)[0].second, a.facts(t_end)[1].second};
}

/// Lumped linear elements: w_h = (2 c/h) sin(beta h/2), then the leapfrog's w = 2/dt asin(w_h dt/2).
double closed_form(int cells, int mode) {
    const double h = 25.0 / cells, beta = (2 * mode - 1) * std::numbers::pi / 50, dt = 0.1 * h / 10;
    return 2 / dt * std::asin(2 * 10 / h * std::sin(beta * h / 2) * dt / 2) / (10 * beta) - 1;
}

TEST(FemBar, FrequencyOfLumpedLinearElements) {
    for (const int mode : {1, 2, 3})
        for (const int gauss : {1, 2, 3}) {  // the strain is constant in an element: any number of points gives the same stiffness
            const double exact = closed_form(16, mode);
            EXPECT_NEAR((vibrate<TotalFem>(16, gauss, mode).frequency), exact, 5e-5);  // zeros by linear interpolation over a few periods
            EXPECT_NEAR((vibrate<UpdatedFem>(16, gauss, mode).frequency), exact, 5e-5);
        }
}
TEST(FemBar, FrequencyInModeTen) { EXPECT_NEAR((vibrate<TotalFem>(50, 2, 10, 20).frequency), closed_form(50, 10), 5e-5); }

TEST(FemBar, KeepsItsEnergy) {
    EXPECT_NEAR((vibrate<TotalFem>(50, 2, 10, 100).energy), 1, 1e-3);  // means over a period of 106 steps
    EXPECT_NEAR((vibrate<UpdatedFem, Lagrange2>(25, 2, 10, 100).energy), 1, 1e-3);
}

/// Quadratic elements converge with order 4 in frequency when their mass is lumped as Simpson's rule does; at 16 elements dt leaves more
/// than h does.
TEST(FemBar, QuadraticElementsAreFarMoreAccurate) {
    const double h = 25.0 / 16, beta = 5 * std::numbers::pi / 50, dt = 0.1 * h / 10;
    const double leapfrog = 2 / dt * std::asin(10 * beta * dt / 2) / (10 * beta) - 1;
    EXPECT_NEAR((vibrate<TotalFem, Lagrange2>(16, 2, 3).frequency), leapfrog, 1e-4);
    EXPECT_GT(std::abs(closed_form(16, 3)), 9e-3);
}

}  // namespace
}  // namespace mpm::test
