// The series of the heated slab: they solve the heat equation and meet their boundary and initial values.
#include "chapters/scenes/slab_exact.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace mpm {
namespace {

struct Named {
    const char* name;
    std::function<double(double, double)> T;
};
const std::vector<Named> all{
    {"between_held_ends", slab::between_held_ends},
    {"held_ends", slab::held_ends},
    {"heated_evenly", [](double xi, double Fo) { return slab::heated_evenly(xi, Fo) - Fo; }},  // less what its source gives
    {"heated_end", slab::heated_end},
    {"insulated", slab::insulated},
    {"convective_end", slab::ConvectiveEnd(1.7)}};

TEST(SlabExact, SolvesTheHeatEquation) {
    for (const Named& s : all)
        for (const double xi : {0.1, 0.5, 0.83}) {
            const double Fo = 0.04, d = 1e-3, dt = 1e-5;  // differences of second order: 1e-6 of fourth derivatives up to 100
            const double rate = (s.T(xi, Fo + dt) - s.T(xi, Fo - dt)) / (2 * dt);
            const double curvature = (s.T(xi + d, Fo) - 2 * s.T(xi, Fo) + s.T(xi - d, Fo)) / (d * d);
            EXPECT_NEAR(rate, curvature, 1e-4) << s.name << " at " << xi;
        }
}

TEST(SlabExact, MeetsItsBoundaries) {
    const double Fo = 0.03, d = 1e-6;  // one-sided differences of first order
    const auto slope = [&](const auto& T, double at, double side) { return side * (T(at, Fo) - T(at - side * d, Fo)) / d; };
    EXPECT_NEAR(slab::between_held_ends(0, Fo), 0, 1e-12);
    EXPECT_NEAR(slab::between_held_ends(1, Fo), 1, 1e-12);
    EXPECT_NEAR(slab::held_ends(0, Fo), 0, 1e-12);
    EXPECT_NEAR(slab::held_ends(1, Fo), 0, 1e-12);
    EXPECT_NEAR(slope(slab::heated_end, 0, -1), 0, 1e-5);
    EXPECT_NEAR(slope(slab::heated_end, 1, 1), 1, 1e-5);
    const slab::ConvectiveEnd end(1.7);
    EXPECT_NEAR(slope(end, 0, -1), 0, 1e-5);
    EXPECT_NEAR(slope(end, 1, 1), -1.7 * end(1, Fo), 1e-5);
}

TEST(SlabExact, IsOneFunctionEarlyAndLate) {
    const double before = 0.005 * (1 - 1e-12), after = 0.005 * (1 + 1e-12);
    ASSERT_TRUE(slab::early(before) && !slab::early(after));
    for (const Named& s : all)
        for (const double xi : {0.0, 0.2, 0.5, 0.9, 0.99, 1.0})
            EXPECT_NEAR(s.T(xi, before), s.T(xi, after), 1e-12) << s.name << " at " << xi;
    for (const double Bi : {1e-3, 1e3})
        EXPECT_NEAR(slab::ConvectiveEnd(Bi)(0.99, before), slab::ConvectiveEnd(Bi)(0.99, after), 1e-12) << Bi;
    EXPECT_NEAR(slab::erfcx(24.999999), slab::erfcx(25.000001), 2e-9);  // its slope, 9e-4, times 2e-6
}

TEST(SlabExact, MeansAreMeans) {
    for (const double Fo : {1e-3, 0.02, 0.5}) {
        double held = 0, evenly = 0;
        const int n = 20000;  // midpoints: second order, 1e-9 of curvatures up to 1e3
        for (int i = 0; i < n; ++i)
            held += slab::between_held_ends((i + 0.5) / n, Fo) / n, evenly += slab::heated_evenly((i + 0.5) / n, Fo) / n;
        EXPECT_NEAR(slab::between_held_ends_mean(Fo), held, 1e-7) << Fo;
        EXPECT_NEAR(slab::heated_evenly_mean(Fo), evenly, 1e-7) << Fo;
    }
}

TEST(SlabExact, ComesFromItsStart) {
    const double Fo = 1e-6;  // heat has come sqrt(Fo) = 1e-3 far
    for (const double xi : {0.2, 0.5, 0.9}) {
        EXPECT_NEAR(slab::between_held_ends(xi, Fo), 0, 1e-9);
        EXPECT_NEAR(slab::held_ends(xi, Fo), 1, 1e-9);
        EXPECT_NEAR(slab::heated_end(xi, Fo), 0, 1e-9);
        EXPECT_NEAR(slab::ConvectiveEnd(1.7)(xi, Fo), 1, 1e-9);
    }
}

}  // namespace
}  // namespace mpm
