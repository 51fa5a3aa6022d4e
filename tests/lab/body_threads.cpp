// The sweeps over particles and nodes in several threads: every particle and node once, no node shared by two threads at a time, sums that
// repeat bit for bit, the failure that one thread would report.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "chapters/weighting/shapes.hpp"
#include "chapters/weighting/tensor.hpp"
#include "lab/body.hpp"

namespace mpm {
namespace {

struct Dot {
    static constexpr int D = 2;
    Vec<2> X = Vec<2>::Zero(), x = Vec<2>::Zero();
    Mat<2> F = identity<2>();
    double m = 0;
    int visits = 0;
};
struct Sum {
    double m = 0;
    std::thread::id writer;  // since the last hand-over
    void reset() { *this = Sum(); }
};
struct NoLaw {};
struct NoTransfer {};
template <class Shape> using Dots = Body<2, Dot, Sum, NoLaw, Shape, NoTransfer>;

/// `count` dots at random places with x in [0, cells] and y in [low, high] cells.
std::vector<Dot> random_dots(std::size_t count, int cells, double low, double high, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(0, cells), y(low, high), m(0.5, 1.5);
    std::vector<Dot> dots(count);
    for (Dot& p : dots) {
        p.x = p.X = Vec<2>(x(random), y(random));
        p.m = m(random);
    }
    return dots;
}

template <class Kernel> Dots<Tensor<2, Kernel>> body_of(std::vector<Dot> dots, int cells, int threads) {
    const Lattice<2> lattice(Vec<2>::Zero(), Vec<2>::Ones(), {cells, cells}, Kernel::per_cell);
    Dots<Tensor<2, Kernel>> body{{std::move(dots), Grid<2, Sum>(lattice), {}}, {lattice, sized<Kernel>(1)}, {}};
    body.grid.use_threads(threads);
    return body;
}

template <class Body> std::vector<double> masses(Body& body) {
    body.grid.reset();
    scatter(body, [](auto& p, const auto& weights) {
        ++p.visits;
        for (const auto& [node, phi, grad] : weights) node.m += phi * p.m;
    });
    std::vector<double> m;
    for (const Sum& node : body.grid) m.push_back(node.m);
    return m;
}

template <class Kernel> class Sweeps : public testing::Test {};
using Kernels = testing::Types<Hat, Ugimp, Cpgimp, Quadratic, Cubic, Bernstein>;
TYPED_TEST_SUITE(Sweeps, Kernels);

/// Rounding of sums of about fifty terms of order one.
constexpr double rounding = 1e-13;

TYPED_TEST(Sweeps, SumsAreThoseOfOneThreadAndTheSameForAnyOtherNumber) {
    const auto dots = random_dots(3000, 40, 0, 40);
    auto one = body_of<TypeParam>(dots, 40, 1), two = body_of<TypeParam>(dots, 40, 2);
    const auto expected = masses(one), first = masses(two);
    for (std::size_t I = 0; I < expected.size(); ++I) ASSERT_NEAR(first[I], expected[I], rounding);
    for (const int threads : {2, 3, 4, 7, 64}) {
        auto many = body_of<TypeParam>(dots, 40, threads);
        EXPECT_EQ(masses(many), first) << threads << " threads";
    }
    for (const Dot& p : two.points) ASSERT_EQ(p.visits, 1);
}

TYPED_TEST(Sweeps, ParticlesThatWentAnywhereAreStillVisitedOnce) {
    auto one = body_of<TypeParam>(random_dots(3000, 40, 0, 40), 40, 1), two = body_of<TypeParam>(one.points, 40, 2);
    masses(two);
    const auto moved = random_dots(3000, 40, 0, 40, 2);
    for (std::size_t i = 0; i < moved.size(); ++i) one.points[i].x = two.points[i].x = moved[i].x;
    for (const bool with_new_strips : {false, true}) {
        const auto expected = masses(one), sums = masses(two);
        for (std::size_t I = 0; I < expected.size(); ++I) ASSERT_NEAR(sums[I], expected[I], rounding);
        EXPECT_EQ(two.strips.strays() > 0, !with_new_strips);
    }
    for (const Dot& p : two.points) ASSERT_EQ(p.visits, 3);
}

TYPED_TEST(Sweeps, StripsOfOneColourReachNoCommonNode) {
    auto body = body_of<TypeParam>(random_dots(1000, 40, 0, 40), 40, 2);
    masses(body);
    const auto& lattice = body.grid.lattice();
    const int strips = body.strips.count(), row = lattice.nodes(0);
    EXPECT_GE(strips * body.strips.height(), lattice.nodes(1));
    for (int s = 2; s < strips; ++s) {
        const auto below = body.strips.reach(s - 2), here = body.strips.reach(s);
        EXPECT_LE(below.lowest + below.count + (TypeParam::support - 1) * row, here.lowest);
    }
}

/// Each node remembers who wrote to it in a colour, even after particles have drifted as far as their strips allow.
TYPED_TEST(Sweeps, ThreadsShareNoNodeInAColour) {
    auto body = body_of<TypeParam>(random_dots(20000, 40, 0, 40), 40, 2);
    masses(body);
    const double drift = TypeParam::per_cell == 1 ? 0.9 : 0;  // one row
    for (Dot& p : body.points) {
        p.visits = body.shape(p, 0)[0].node / body.grid.lattice().nodes(0) / body.strips.height();  // its strip
        p.x[1] = std::clamp(p.x[1] + (p.m > 1 ? drift : -drift), 0.0, 40.0);
    }
    body.grid.reset();
    std::mutex mutex;
    int shared = 0;
    scatter(body, [&](auto& p, const auto& weights) {
        const std::lock_guard lock(mutex);
        for (const auto& [node, phi, grad] : weights) {
            const int colour = 1 + p.visits % 2;
            if (node.m == colour && node.writer != std::this_thread::get_id()) ++shared;
            node.m = colour;
            node.writer = std::this_thread::get_id();
        }
    });
    EXPECT_EQ(body.strips.strays(), 0u);
    EXPECT_EQ(shared, 0);
}

TYPED_TEST(Sweeps, GridsOfFewRowsHaveOneStrip) {
    const int cells = TypeParam::min_cells;
    const auto dots = random_dots(50, cells, 0, cells);
    auto one = body_of<TypeParam>(dots, cells, 1), four = body_of<TypeParam>(dots, cells, 4);
    const auto expected = masses(one), sums = masses(four);
    EXPECT_EQ(four.strips.count(), 1);
    for (std::size_t I = 0; I < expected.size(); ++I) EXPECT_EQ(sums[I], expected[I]);  // in the order of one thread
}

TEST(BodyThreads, AnEmptyBodyIsSwept) {
    auto body = body_of<Hat>({}, 10, 3);
    for (const double m : masses(body)) EXPECT_EQ(m, 0);
    gather(body, [](auto&, const auto&) { FAIL(); });
}

TEST(BodyThreads, AllParticlesMayLieInOneStrip) {
    const auto dots = random_dots(500, 40, 20, 20.5);
    auto one = body_of<Hat>(dots, 40, 1), three = body_of<Hat>(dots, 40, 3);
    EXPECT_EQ(masses(three), masses(one));  // one strip: the order of one thread
}

TEST(BodyThreads, ParticlesMayComeAndGo) {
    auto body = body_of<Quadratic>(random_dots(100, 40, 0, 40), 40, 2);
    for (const std::size_t count : {100u, 300u, 20u, 0u, 50u}) {
        body.points = random_dots(count, 40, 0, 40);
        auto one = body_of<Quadratic>(body.points, 40, 1);
        const auto sums = masses(body), expected = masses(one);
        for (std::size_t I = 0; I < sums.size(); ++I) ASSERT_NEAR(sums[I], expected[I], rounding);
    }
}

/// What one thread would throw: that of the lowest particle, which no thread meets first every time.
template <class Sweep> std::string thrown(Sweep&& sweep) {
    try {
        sweep();
    } catch (const OutsideGrid& outside) {
        return outside.what();
    }
    return "nothing";
}
TEST(BodyThreads, TheLowestParticleOutsideIsReported) {
    for (const int threads : {1, 2, 3}) {
        auto body = body_of<Hat>(random_dots(2000, 40, 0, 40), 40, threads);
        if (threads > 1) masses(body);  // with strips at hand, and without
        for (const int repeat : {0, 1, 2}) {
            body.points[1500].x[1] = -1 - repeat;
            body.points[1501].x[0] = 77;
            body.points[900].x[0] = 41.5;
            EXPECT_EQ(thrown([&] { masses(body); }), "position 41.500000 outside the grid [0.000000, 40.000000] along axis 0");
            EXPECT_EQ(thrown([&] { gather(body, [](auto&, const auto&) {}); }),
                      "position 41.500000 outside the grid [0.000000, 40.000000] along axis 0");
            body.strips.forget();
        }
    }
}
TEST(BodyThreads, AVisitMayThrowAndTheNextSweepIsWhole) {
    auto body = body_of<Hat>(random_dots(2000, 40, 0, 40), 40, 2);
    const auto whole = masses(body);
    for (int repeat = 0; repeat < 20; ++repeat) {
        const auto fail = [&](auto& p, const auto&) {
            const auto i = &p - body.points.data();
            if (i % 7 == 3) throw OutsideGrid(std::to_string(i));
        };
        EXPECT_EQ(thrown([&] { scatter(body, fail); }), "3");
        EXPECT_EQ(thrown([&] { gather(body, fail); }), "3");
    }
    EXPECT_EQ(masses(body), whole);
}

TEST(BodyThreads, EveryNodeIsVisitedOnce) {
    for (const int threads : {1, 2, 5}) {
        auto body = body_of<Hat>({}, 10, threads);
        each(body.grid, [](Sum& node) { node.m += 1; });
        for (const Sum& node : body.grid) EXPECT_EQ(node.m, 1);
        EXPECT_EQ(thrown([&] {
                      each(body.grid, [&](Sum& node) {
                          const auto I = &node - &body.grid[0];
                          if (I >= 17) throw OutsideGrid(std::to_string(I));
                      });
                  }),
                  "17");
    }
}

TEST(BodyThreads, OneDimensionHasOneThread) {
    Grid<1, Sum> grid(Lattice<1>(Vec<1>(0.0), Vec<1>(1.0), {5}));
    grid.use_threads(8);
    EXPECT_EQ(grid.threads(), 1);
}

/// A shape that says nothing of its rows may keep a buffer.
struct Buffered {
    Tensor<2, Hat> shape;
    Stencil<2, 4> kept{};
    const Stencil<2, 4>& operator()(const Dot& p, std::size_t i) { return kept = shape(p, i); }
};
TEST(BodyThreads, AShapeWithoutRowsIsSweptByOneThread) {
    const auto dots = random_dots(500, 40, 0, 40);
    auto one = body_of<Hat>(dots, 40, 1);
    Dots<Buffered> body{{dots, one.grid, {}}, {one.shape}, {}};
    body.grid.use_threads(4);
    const auto me = std::this_thread::get_id();
    gather(body, [&](auto&, const auto&) { EXPECT_EQ(std::this_thread::get_id(), me); });
    EXPECT_EQ(masses(body), masses(one));
}

TEST(Threads, EachPartIsCalledOnce) {
    for (const int parts : {1, 2, 3, 300, 2}) {
        std::vector<std::atomic<int>> calls(static_cast<std::size_t>(parts));
        in_threads(parts, [&](int k) { ++calls[static_cast<std::size_t>(k)]; });
        for (const auto& c : calls) EXPECT_EQ(c, 1);
    }
}
TEST(Threads, APartMayShareItsOwnWork) {
    std::atomic<int> calls = 0;
    in_threads(3, [&](int) { in_threads(4, [&](int) { ++calls; }); });
    EXPECT_EQ(calls, 12);
}

}  // namespace
}  // namespace mpm
