// The watch for locking, on pressures made by hand.
#include "lab/locking.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "chapters/explicit/point.hpp"
#include "chapters/material/linear_elastic.hpp"
#include "chapters/material/neo_hookean.hpp"

namespace mpm {
namespace {

using Solid = Matter<2, Point<2>, Node<2>, NeoHookean>;

/// 4 x 4 cells with 2 x 2 particles each; `pressure(i, j)` of the particle in column i and row j, and a shear stress of 1.
template <class Pressure> Solid block(Pressure&& pressure) {
    std::vector<Point<2>> points;
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 8; ++i) {
            Point<2>& p = points.emplace_back();
            p.X = p.x = Vec<2>(0.25 + 0.5 * i, 0.25 + 0.5 * j);
            p.m = p.V = p.V0 = 0.25;
            p.sigma = -pressure(i, j) * identity<2>();
            p.sigma(0, 1) = p.sigma(1, 0) = 1;
        }
    return {points, Grid<2, Node<2>>(Lattice<2>(Vec<2>::Zero(), Vec<2>::Ones(), {4, 4})), NeoHookean{1e4, 1, 1}};
}
double by_turns(int i, int j) { return (i + j) % 2 == 0 ? 10 : -10; }

/// What it says at the n-th record.
Trouble after(int records, const Solid& body) {
    LockingWatch<Solid> watch(body, 100);
    Trouble trouble;
    for (int i = 0; i < records; ++i) trouble = watch.check(body);
    return trouble;
}

TEST(Locking, PressuresByTurnsLockAtTheFifthRecord) {
    const Solid body = block(by_turns);
    EXPECT_FALSE(after(4, body));
    const Trouble trouble = after(5, body);
    EXPECT_EQ(trouble.cause, "locking");
    EXPECT_NE(trouble.reason.find("100 % of the rms pressure, 10 times"), std::string::npos) << trouble.reason;
}
TEST(Locking, APressureThatGrowsAlongTheBodyIsNone) { EXPECT_FALSE(after(9, block([](int i, int) { return 10. * i; }))); }
TEST(Locking, NorAreSmallDifferencesBesideTheShear) { EXPECT_FALSE(after(9, block([](int i, int j) { return 0.1 * by_turns(i, j); }))); }
TEST(Locking, NorIsRounding) {
    Solid body = block(by_turns);
    for (auto& p : body.points) p.sigma *= 1e-9;  // rho c^2 = 1e4
    EXPECT_FALSE(after(9, body));
}
TEST(Locking, FollowsParticlesThatChangePlacesInTheList) {
    Solid body = block([](int i, int j) { return i / 2 % 2 == j / 2 % 2 ? 10. : -10.; });  // cell by cell: no locking
    LockingWatch<Solid> watch(body, 100);
    body.number_points();
    std::swap(body.points[0], body.points[63]);
    std::swap(body.points[1], body.points[2]);
    std::swap(body.numbers[0], body.numbers[63]);
    std::swap(body.numbers[1], body.numbers[2]);
    for (int i = 0; i < 9; ++i) EXPECT_FALSE(watch.check(body));
}
TEST(Locking, OnlyNearlyIncompressibleSolidsCan) {
    EXPECT_TRUE(can_lock(NeoHookean{100, 1, 1}));  // nu = 0.495
    EXPECT_FALSE(can_lock(NeoHookean{10, 1, 1}));  // nu = 0.455
    EXPECT_FALSE(can_lock(LinearElastic{1, 1, 1}));
    struct Other {};
    EXPECT_FALSE(can_lock(Other{}));
}

}  // namespace
}  // namespace mpm
