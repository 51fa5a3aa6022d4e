// The manufactured motions of the plane against differences of themselves: no misprint passes, and those of the review are caught.
#include <gtest/gtest.h>

#include <random>

#include "chapters/explicit/point.hpp"
#include "chapters/mms/square.hpp"
#include "chapters/mms/vortex.hpp"

namespace mpm::test {
namespace {

/// Derivative of a vector by central differences of fourth order.
template <class Function> Vec<2> slope(const Function& f, double x, double step) {
    return (8 * (f(x + step) - f(x - step)) - (f(x + 2 * step) - f(x - 2 * step))) / (12 * step);
}

/// First Piola-Kirchhoff stress of the law: P = sigma cof F.
template <class Motion> Mat<2> stress(const Motion& m, const Vec<2>& X, double t) {
    Point<2> p;
    p.F = m.F(X, t);
    NeoHookean{m.lambda(), m.mu(), m.rho}.update(p, p.F, 0);
    return p.sigma * cofactor(p.F);
}

/// a - Div P/rho, by differences: the body force that the motion needs.
template <class Motion> Vec<2> needed_force(const Motion& m, const Vec<2>& X, double t) {
    constexpr double step = 1e-3;  // leaves 1e-12 of the fifth derivative over 30, and rounding of 1e-13 of the stress
    Vec<2> div = Vec<2>::Zero();
    for (int d = 0; d < 2; ++d) {
        const Vec<2> e = Vec<2>::Unit(d);
        div += slope([&](double s) { return Vec<2>(stress(m, Vec<2>(X + s * e), t).col(d)); }, 0, step);
    }
    const Vec<2> a = slope([&](double s) { return m.v(X, s); }, t, step * m.period());
    return a - div / m.rho;
}

/// Calls check(motion, X, t) at 200 random places and times.
template <class Check> void in_the_square(Check&& check) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> part(0, 1);
    for (int i = 0; i < 200; ++i) {
        SquareMotion m;
        m.G = std::pow(10, -4 + 3 * part(random));
        m.nu = 0.49 * part(random);
        check(m, Vec<2>(part(random), part(random)), m.period() * part(random));
    }
}
template <class Check> void in_the_ring(Check&& check) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> part(0, 1);
    for (int i = 0; i < 200; ++i) {
        const VortexMotion m;
        const double R = m.R_i + m.width() * part(random), angle = 2 * std::numbers::pi * part(random);
        check(m, Vec<2>(R * std::cos(angle), R * std::sin(angle)), m.T0 * part(random));
    }
}

template <class Motion> void expect_derivatives(const Motion& m, const Vec<2>& X, double t) {
    // Fourth-order differences with steps of 1e-3: 1e-12 times the fifth derivative, which the vortex takes to some 1e4.
    const Vec<2> v = slope([&](double s) { return m.x(X, s); }, t, 1e-3 * m.period());
    EXPECT_LT((m.v(X, t) - v).norm(), 1e-8 * (m.omega() * m.G));
    for (int d = 0; d < 2; ++d) {
        const Vec<2> column = slope([&](double s) { return m.x(Vec<2>(X + s * Vec<2>::Unit(d)), t); }, 0, 1e-3);
        EXPECT_LT((m.F(X, t).col(d) - column).norm(), 1e-7 * m.G);
    }
    EXPECT_LT((m.X_of(m.x(X, t), t) - X).norm(), 1e-13);
    EXPECT_LT((m.x(X, t) - X - m.u(X, t)).norm(), 1e-15);
}
TEST(SquareMotion, VelocityAndGradientAreDerivatives) {
    in_the_square([](const auto& m, const Vec<2>& X, double t) { expect_derivatives(m, X, t); });
}
TEST(VortexMotion, VelocityAndGradientAreDerivatives) {
    in_the_ring([](const auto& m, const Vec<2>& X, double t) { expect_derivatives(m, X, t); });
}

/// (6.9) with F33 = 1. Larger by far than the error allowed: 1e-5 of the divergence's size.
TEST(SquareMotion, BodyForceBalancesStressAndAcceleration) {
    in_the_square([](const SquareMotion& m, const Vec<2>& X, double t) {
        const double size = (m.lambda() + 2 * m.mu()) / m.rho * m.k_pi() * m.k_pi() * m.G;
        EXPECT_LT((m.b(X, t) - needed_force(m, X, t)).norm(), 1e-6 * size) << "G = " << m.G << ", X = " << X.transpose();
    });
}
TEST(SquareMotion, StretchesOppositeAxesInTurn) {
    const SquareMotion m;
    const double t = m.period() / 4;
    EXPECT_NEAR(m.u({0.5, 0.5}, t)[0], m.G, 1e-18);
    EXPECT_NEAR(m.u({0.5, 0.5}, t)[1], -m.G, 1e-18);  // phi_2 = pi
}
/// (6.10) fixes only the normal component: along a face the material moves.
TEST(SquareMotion, SlipsAlongItsFaces) {
    const SquareMotion m;
    const double speed = m.omega() * m.G;
    for (const double face : {0.0, 1.0}) {
        EXPECT_NEAR(m.v({face, 0.5}, 0)[0], 0, 1e-15 * speed);
        EXPECT_NEAR(m.v({face, 0.5}, 0)[1], -speed, 1e-12 * speed);
    }
}

TEST(VortexMotion, BodyForceBalancesStressAndAcceleration) {
    in_the_ring([](const VortexMotion& m, const Vec<2>& X, double t) {
        EXPECT_LT((m.b(X, t) - needed_force(m, X, t)).norm(), 1e-6 * (1 + m.b(X, t).norm())) << "X = " << X.transpose();
    });
}
/// The body force as (6.17) and (6.18) print it; with `sign` = -1 the last bracket of b_Theta reads as it must.
Vec<2> printed_force(const VortexMotion& m, const Vec<2>& X, double t, double sign) {
    const double R = X.norm(), g = m.g(t), alpha = m.angle(R, t), c2 = m.mu() / m.rho;
    const double first = c2 * (3 * g * m.h1(R) + R * g * m.h2(R)) - R * m.g2(t) * m.h(R);
    const double elastic = c2 * R * std::pow(g * m.h1(R), 2), inertia = R * std::pow(m.g1(t) * m.h(R), 2);
    const double b_R = first * std::sin(alpha) + (elastic - inertia) * std::cos(alpha);
    const double b_Theta = -first * std::cos(alpha) + (elastic + sign * inertia) * std::sin(alpha);
    return Vec<2>(b_R * X[0] - b_Theta * X[1], b_Theta * X[0] + b_R * X[1]) / R;
}
TEST(VortexMotion, ThePrintedBodyForceHasAWrongSign) {
    double worst = 0;
    in_the_ring([&](const VortexMotion& m, const Vec<2>& X, double t) {
        EXPECT_LT((m.b(X, t) - printed_force(m, X, t, -1)).norm(), 1e-12 * (1 + m.b(X, t).norm()));
        worst = std::max(worst, (m.b(X, t) - printed_force(m, X, t, 1)).norm());
    });
    EXPECT_GT(worst, 5);  // of some 30: the body force of this motion
}
/// Nor is the initial velocity zero, as printed.
TEST(VortexMotion, StartsInMotionFromRestingStress) {
    in_the_ring([](const VortexMotion& m, const Vec<2>& X, double) {
        const Vec<2> along(-X[1], X[0]);  // R e_Theta
        EXPECT_LT((m.v(X, 0) - m.G * std::numbers::pi / m.T0 * m.h(X.norm()) * along).norm(), 1e-14);
        EXPECT_LT(m.u(X, 0).norm(), 1e-16);
        EXPECT_LT(stress(m, X, 0).norm(), 1e-12);
    });
    const VortexMotion m;
    EXPECT_NEAR(m.v({1, 0}, 0)[1], std::numbers::pi, 1e-14);
}
TEST(VortexMotion, KeepsItsVolumeAndLeavesItsEdgesFree) {
    in_the_ring([](const VortexMotion& m, const Vec<2>& X, double t) {
        EXPECT_NEAR(m.F(X, t).determinant(), 1, 1e-13);
        for (const double R : {m.R_i, m.R_o}) {
            const Vec<2> N = X.normalized(), edge = R * N;
            EXPECT_LT((stress(m, edge, t) * N).norm(), 1e-10);  // R is off by 1e-16, the slope of the stress there mu h'' = 5e4
            EXPECT_LT(m.u(edge, t).norm(), 1e-14);
        }
    });
}

/// The waves that bound the time step, from the law itself: rho c^2 m = A(N) m with A(N) m = dP(F + s m N^T)/ds N in the initial
/// configuration, N = F^T n for a plane wave along n in the deformed one.
TEST(Vortex, WaveSpeedIsThatOfTheShearedSolid) {
    const VortexCase ring;
    const NeoHookean law{ring.lambda(), ring.mu(), ring.rho};
    Mat<2> F = Mat<2>::Identity();
    F(0, 1) = ring.largest_shear();
    const auto speed = [&](const Vec<2>& N) {
        Mat<2> A;
        for (int d = 0; d < 2; ++d)
            A.col(d) = slope(
                [&](double s) {
                    Point<2> p;
                    p.F = F + s * Vec<2>::Unit(d) * N.transpose();
                    law.update(p, p.F, 0);
                    return Vec<2>(p.sigma * cofactor(p.F) * N);
                },
                0, 1e-4);
        const double half = A.trace() / 2;  // the larger eigenvalue
        return std::sqrt((half + std::sqrt(half * half - A.determinant())) / law.rho);
    };
    double initial = 0, deformed = 0;
    for (int i = 0; i < 3600; ++i) {
        const Vec<2> n(std::cos(i * std::numbers::pi / 3600), std::sin(i * std::numbers::pi / 3600));
        initial = std::max(initial, speed(n));
        deformed = std::max(deformed, speed(F.transpose() * n));
    }
    EXPECT_NEAR(Vortex<true>(ring).wave_speed(), initial, 1e-4 * initial);  // directions half a mrad apart
    EXPECT_NEAR(Vortex<false>(ring).wave_speed(), deformed, 1e-4 * deformed);
}
TEST(Vortex, SpeedAndShearAreTheLargestOfTheMotion) {
    const VortexCase ring;
    double speed = 0, shear = 0;
    for (int i = 0; i <= 10000; ++i) {
        const double R = ring.R_i + ring.width() * i / 10000;
        speed = std::max(speed, ring.v({R, 0}, 0).norm());
        shear = std::max(shear, R * std::abs(ring.g(ring.T0 / 2) * ring.h1(R)));
    }
    EXPECT_NEAR(Vortex<true>(ring).speed(), speed, 1e-3 * speed);  // to second order in the width, here a half of the radius
    EXPECT_NEAR(ring.largest_shear(), shear, 0.02 * shear);        // R grows where h' falls
    EXPECT_GE(ring.largest_shear(), 6);
}

}  // namespace
}  // namespace mpm::test
