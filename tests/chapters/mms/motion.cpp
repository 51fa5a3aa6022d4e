// The manufactured motion against differences of itself: no misprint passes.
#include "chapters/mms/motion.hpp"

#include <gtest/gtest.h>

#include <random>

#include "chapters/explicit/point.hpp"
#include "chapters/material/neo_hookean.hpp"

namespace mpm::test {
namespace {

/// Derivative by central differences of fourth order.
template <class Function> double slope(const Function& f, double x, double step) {
    return (8 * (f(x + step) - f(x - step)) - (f(x + 2 * step) - f(x - 2 * step))) / (12 * step);
}

/// Calls check(motion, X, t) at 500 random places and times of as many motions, large and small, stiff and soft.
template <class Check> void everywhere(Check&& check) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> part(0, 1);
    const auto between = [&](double low, double high) { return low * std::pow(high / low, part(random)); };
    for (int i = 0; i < 500; ++i) {
        SegmentMotion m;
        m.mode = 1 + i % 3;
        m.G = between(1e-4, 0.25) / m.mode;  // k pi G up to 0.79
        m.E = between(1e2, 1e9);
        m.nu = 0.49 * part(random);
        m.rho = between(1, 1e4);
        const double X = part(random), t = m.period() * part(random);
        SCOPED_TRACE("G = " + std::to_string(m.G) + ", nu = " + std::to_string(m.nu) + ", X = " + std::to_string(X));
        check(m, X, t);
        if (testing::Test::HasFailure()) return;
    }
}

// Steps of 1e-3 leave 1e-10 of the fifth derivative (mode 3: 7e4 times the function's size over 30) and 1e-13 of rounding.
constexpr double dX = 1e-3;

TEST(Motion, VelocityAndStretchAreDerivativesOfTheDisplacement) {
    everywhere([](const SegmentMotion& m, double X, double t) {
        EXPECT_NEAR(m.v(X, t), slope([&](double s) { return m.u(X, s); }, t, dX / m.omega()), 1e-10 * m.omega() * m.G);
        EXPECT_NEAR(m.F(X, t) - 1, slope([&](double s) { return m.u(s, t); }, X, dX / m.mode), 1e-9 * m.mode * m.G);
    });
}

TEST(Motion, StressIsThatOfTheLaw) {
    everywhere([](const SegmentMotion& m, double X, double t) {
        const NeoHookean law{m.lambda(), m.mu(), m.rho};
        Point<1> p;
        p.V0 = 1;
        const auto energy = [&](double F) {
            p.F(0, 0) = F;
            return law.energy(p);
        };
        const double F = m.F(X, t), P = slope(energy, F, dX * F), stiff = m.lambda() + 2 * m.mu();
        EXPECT_NEAR(m.P(X, t), P, 1e-8 * stiff);  // F reaches 0.2, where higher derivatives are large
        p.F(0, 0) = F;
        law.update(p, p.F, 0);
        EXPECT_NEAR(m.P(X, t), p.sigma(0, 0), 1e-13 * stiff * (1 + std::abs(P) / stiff));  // P = J sigma/F, J = F
    });
}

/// rho a = dP/dX + rho b (A.7).
TEST(Motion, BodyForceBalancesStressAndAcceleration) {
    int far_from_zero = 0;
    everywhere([&](const SegmentMotion& m, double X, double t) {
        const double a = slope([&](double s) { return m.v(X, s); }, t, dX / m.omega());
        const double div_P = slope([&](double s) { return m.P(s, t); }, X, dX / m.mode);
        const double scale = (m.lambda() + 2 * m.mu()) * m.k_pi() * m.k_pi() * m.G;  // of dP/dX
        const double f = std::min(1.0, 1 - m.k_pi() * m.G);                         // smallest F: derivatives grow with its powers
        EXPECT_NEAR(m.rho * m.b(X, t), m.rho * a - div_P, 1e-8 * scale / std::pow(f, 6));
        if (std::abs(m.rho * m.b(X, t)) > 1e-2 * scale) ++far_from_zero;
    });
    EXPECT_GT(far_from_zero, 200);
}

TEST(Motion, StartsStressFreeAndHeldAtBothEnds) {
    everywhere([](const SegmentMotion& m, double X, double t) {
        EXPECT_EQ(m.u(X, 0), 0);
        EXPECT_EQ(m.P(X, 0), 0);
        EXPECT_NEAR(m.u(X, m.period()), 0, 1e-14 * m.G);
        for (const double end : {0.0, 1.0}) {
            EXPECT_NEAR(m.v(end, t), 0, 1e-14 * m.omega() * m.G);
            EXPECT_NEAR(m.b(end, t), 0, 1e-11 * m.omega() * m.omega() * m.G);  // times up to 1/F^2 of 20
        }
    });
}

TEST(Motion, IsInvertedByNewtonsMethod) {
    everywhere([](const SegmentMotion& m, double X, double t) { EXPECT_NEAR(m.X_of(m.x(X, t), t), X, 1e-13); });
}

TEST(Motion, HasTheReviewsNumbers) {
    const SegmentMotion m;
    EXPECT_DOUBLE_EQ(m.period(), 0.02);              // 2 pi/(c pi), c = 100
    EXPECT_NEAR(m.lambda(), 5769230.77, 0.01);       // E nu/((1 + nu)(1 - 2 nu))
    EXPECT_NEAR(m.mu(), 3846153.85, 0.01);           // E/(2 (1 + nu))
    EXPECT_NEAR(m.v(0.5, 0), 1e-2 * 3.14159265, 1e-9);  // pi c G
}

}  // namespace
}  // namespace mpm::test
