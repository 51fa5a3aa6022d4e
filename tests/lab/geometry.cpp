// Plane regions: what is inside, what bounds them, the area they share with rectangles.
#include "lab/geometry.hpp"

#include <gtest/gtest.h>

namespace mpm::test {
namespace {

const Disk disk{Vec<2>(1, 2), 0.5};
const Box box{Vec<2>(0, 0), Vec<2>(1, 3)};
const Ring ring{Vec<2>(0, 0), 1, 2};

TEST(Regions, HoldTheirEdges) {
    EXPECT_TRUE(disk.inside(Vec<2>(1.5, 2)));
    EXPECT_FALSE(disk.inside(Vec<2>(1.5 + 1e-15, 2)));
    EXPECT_TRUE(box.inside(Vec<2>(1, 3)));
    EXPECT_FALSE(box.inside(Vec<2>(1, 3 + 1e-15)));
    EXPECT_TRUE(ring.inside(Vec<2>(1, 0)) && ring.inside(Vec<2>(0, -2)));
    EXPECT_FALSE(ring.inside(Vec<2>(1 - 1e-15, 0)));
    const HalfPlane below{Vec<2>(0, 1), Vec<2>(1, 1)};
    EXPECT_TRUE(below.inside(Vec<2>(0, 1)) && below.inside(Vec<2>(-5, -5)));
    EXPECT_FALSE(below.inside(Vec<2>(0.5, 0.6)));
}
TEST(Regions, HoldNothingThatIsNoNumber) {
    const Vec<2> nowhere(std::numeric_limits<double>::quiet_NaN(), 2);
    EXPECT_FALSE(disk.inside(nowhere) || box.inside(nowhere) || ring.inside(nowhere) || HalfPlane{}.inside(nowhere));
}
TEST(Regions, AreCombined) {
    const Vec<2> in_both(0.9, 2), in_disk(1.2, 2), in_box(0.1, 0.1), outside(3, 3);
    const auto check = [&](const auto& region, bool a, bool b, bool c) {
        EXPECT_EQ(region.inside(in_both), a);
        EXPECT_EQ(region.inside(in_disk), b);
        EXPECT_EQ(region.inside(in_box), c);
        EXPECT_FALSE(region.inside(outside));
    };
    check(disk | box, true, true, true);
    check(disk & box, true, false, false);
    check(disk - box, false, true, false);
    check(box - disk, false, false, true);
    check((disk | box) - (disk & box), false, true, true);
}

TEST(Bounds, AreThoseOfTheParts) {
    const auto expect = [](const Bounds& b, double x0, double y0, double x1, double y1) {
        EXPECT_EQ(b.low, Vec<2>(x0, y0));
        EXPECT_EQ(b.high, Vec<2>(x1, y1));
    };
    expect(disk.bounds(), 0.5, 1.5, 1.5, 2.5);
    expect((disk | box).bounds(), 0, 0, 1.5, 3);
    expect((disk & box).bounds(), 0.5, 1.5, 1, 2.5);
    expect((disk - box).bounds(), 0.5, 1.5, 1.5, 2.5);
}
TEST(Bounds, OfAHalfPlaneAreInfiniteAlongWhatItDoesNotBound) {
    constexpr double inf = Bounds::inf;
    EXPECT_EQ((HalfPlane{Vec<2>(3, 4), Vec<2>(0, 2)}.bounds().high), Vec<2>(inf, 4));
    EXPECT_EQ((HalfPlane{Vec<2>(3, 4), Vec<2>(-1, 0)}.bounds().low), Vec<2>(3, -inf));
    EXPECT_EQ((HalfPlane{Vec<2>(3, 4), Vec<2>(1, 1)}.bounds().high), Vec<2>(inf, inf));
    EXPECT_EQ(((HalfPlane{Vec<2>(3, 4), Vec<2>(0, 2)} & HalfPlane{Vec<2>(0, 0), Vec<2>(-1, 0)}).bounds().high), Vec<2>(inf, 4));
}

/// By the middles of n x n parts.
template <class R> double sampled(const R& region, const Bounds& b, int n) {
    long inside = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) inside += region.inside(b.low + (b.high - b.low).cwiseProduct(Vec<2>(i + 0.5, j + 0.5)) / n) ? 1 : 0;
    return (b.high - b.low).prod() * static_cast<double>(inside) / n / n;
}
TEST(Overlap, AgreesWithSampling) {
    for (const double x : {-2.3, -0.7, -0.2, 0.0, 0.4, 1.1})
        for (const double y : {-1.9, -0.6, 0.0, 0.3, 0.9})
            for (const double w : {0.2, 0.9, 2.5}) {
                const Bounds b{Vec<2>(x, y), Vec<2>(x + w, y + 0.7 * w)};
                // 400 x 400 points: an edge of length 3 w cuts about 1200 parts of area .7 w^2/160000, and their errors mostly cancel
                EXPECT_NEAR((Disk{Vec<2>(0.1, 0), 0.8}.overlap(b)), sampled(Disk{Vec<2>(0.1, 0), 0.8}, b, 400), 2e-3 * w * w);
                EXPECT_NEAR(ring.overlap(b), sampled(ring, b, 400), 2e-3 * w * w);
                EXPECT_NEAR(box.overlap(b), sampled(box, b, 400), 4e-3 * w * w);
            }
}
TEST(Overlap, OfAllIsTheArea) {
    const Bounds all{Vec<2>(-9, -9), Vec<2>(9, 9)}, upper{Vec<2>(-9, 2), Vec<2>(9, 9)}, quarter{Vec<2>(1, 2), Vec<2>(9, 9)};
    EXPECT_NEAR(disk.overlap(all), disk.area(), 1e-15);
    EXPECT_NEAR(disk.overlap(upper), disk.area() / 2, 1e-15);
    EXPECT_NEAR(disk.overlap(quarter), disk.area() / 4, 1e-15);
    EXPECT_NEAR(ring.overlap(all), ring.area(), 1e-14);
    EXPECT_DOUBLE_EQ(box.overlap(all), box.area());
    EXPECT_EQ(box.overlap({Vec<2>(1.5, 0), Vec<2>(2, 1)}), 0);
    EXPECT_EQ(disk.overlap({Vec<2>(5, 0), Vec<2>(6, 1)}), 0);
}

}  // namespace
}  // namespace mpm::test
