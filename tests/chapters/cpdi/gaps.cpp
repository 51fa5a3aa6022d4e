// Areas that polygons cover together, and gaps and overlaps between domains.
#include "chapters/cpdi/gaps.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mpm::test {
namespace {

Corners2 box(double x, double y, double width, double height) { return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}; }
Corners2 turned(const Corners2& polygon, double angle) {
    Corners2 all;
    for (const Vec<2>& x : polygon)
        all.emplace_back(std::cos(angle) * x[0] - std::sin(angle) * x[1], std::sin(angle) * x[0] + std::cos(angle) * x[1]);
    return all;
}

// Exact but for rounding, whatever the direction.
TEST(CoveredArea, CountsWhatIsCoveredOnce) {
    for (const double angle : {0.0, 0.3, M_PI / 4, M_PI / 2, 2.0}) {
        const Corners2 a = turned(box(0, 0, 2, 1), angle), b = turned(box(1.5, 0.5, 2, 1), angle);
        const Corners2 inner = turned(box(0.5, 0.25, 1, 0.5), angle);
        EXPECT_NEAR(covered_area({a}), 2, 1e-14);
        EXPECT_NEAR(covered_area({a, a}), 2, 1e-14);
        EXPECT_NEAR(covered_area({a, b}), 3.75, 1e-14);
        EXPECT_NEAR(covered_area({a, inner}), 2, 1e-14);
        EXPECT_NEAR(covered_area({a, b, inner}), 3.75, 1e-14);
    }
}
// A triangle in a triangle turned round: a star of David, 4/3 of one of them.
TEST(CoveredArea, KnowsWhereEdgesCross) {
    Corners2 up, down;
    for (int c = 0; c < 3; ++c) {
        const double angle = M_PI / 2 + 2 * M_PI * c / 3;
        up.emplace_back(std::cos(angle), std::sin(angle)), down.emplace_back(-std::cos(angle), -std::sin(angle));
    }
    EXPECT_NEAR(covered_area({up, down}), std::sqrt(3.0), 1e-14);  // the triangle's is 3 sqrt(3)/4
}
TEST(CoveredArea, TakesConcavePolygons) { EXPECT_NEAR(covered_area({{{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}}}), 2.5, 1e-14); }

const PolygonCells two{{{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}}, {{0, 1, 4, 3}, {1, 2, 5, 4}}};

TEST(Gaps, AreNoneWhereCornersAreShared) {
    const Gaps gaps = gaps_between(two, {{{0, 0}, {1.1, 0.2}, {0.9, 1.1}, {0, 1}}, {{1.1, 0.2}, {2, 0}, {2, 1}, {0.9, 1.1}}});
    EXPECT_EQ(gaps.gap, 0);
    EXPECT_NEAR(gaps.overlap, 0, 1e-15);
}
TEST(Gaps, AreCountedBetweenDomainsThatPart) {
    const Gaps gaps = gaps_between(two, {box(0, 0, 0.9, 1), box(1.1, 0, 0.9, 1)});
    EXPECT_NEAR(gaps.gap, 0.2, 1e-15);
    EXPECT_NEAR(gaps.overlap, 0, 1e-15);
}
TEST(Gaps, AreOverlapsWhereDomainsCoverEachOther) {
    const Gaps gaps = gaps_between(two, {box(0, 0, 1.1, 1), box(0.9, 0, 1.1, 1)});
    EXPECT_NEAR(gaps.gap, 0, 1e-15);
    EXPECT_NEAR(gaps.overlap, 0.2, 1e-15);
}

}  // namespace
}  // namespace mpm::test
