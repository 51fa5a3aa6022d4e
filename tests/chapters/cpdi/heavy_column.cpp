// The heavy column's state of rest against a quadrature of its own.
#include "chapters/scenes/heavy_column.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mpm::test {
namespace {

/// P(F) = mu (F - 1/F) + lambda ln F / F of a neo-Hookean solid in uniaxial strain.
double stretch_under(const HeavyColumn& column, double P) {
    double F = 1;  // Newton's method; P(F) is smooth and grows
    for (int i = 0; i < 50; ++i) {
        const double residual = column.mu() * (F - 1 / F) + column.lambda() * std::log(F) / F - P;
        F -= residual / (column.mu() * (1 + 1 / (F * F)) + column.lambda() * (1 - std::log(F)) / (F * F));
    }
    return F;
}

// P(F(X)) = rho g (L - X) pointwise, F - 1 integrated by Simpson's rule with 1000 intervals: its error is below 1e-12 here.
TEST(HeavyColumnScene, KnowsItsStateOfRest) {
    for (const double gravity : {250.0, 1000.0}) {
        HeavyColumn column;
        column.gravity = gravity;
        column.sides = "held";
        constexpr int n = 1000;
        double sum = 0;
        for (int i = 0; i <= n; ++i) {
            const double above = column.length * i / n, weight = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
            sum += weight * (stretch_under(column, column.rho * gravity * (column.length - above)) - 1);
        }
        EXPECT_NEAR(column.static_tip(), sum * column.length / (3 * n), 1e-10);
    }
}
TEST(HeavyColumnScene, HasAnExactStateOfRestWithHeldSidesOnly) { EXPECT_TRUE(std::isnan(HeavyColumn().static_tip())); }

}  // namespace
}  // namespace mpm::test
