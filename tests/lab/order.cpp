// Particles in cell order: a stable sort that carries numbers with it, when it pays, and output that does not depend on it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "lab/order.hpp"
#include "lab/columns.hpp"
#include "lab/snapshot.hpp"
#include "tests/chapters/explicit/problem.hpp"

namespace mpm::test {
namespace {

/// A square of 16 x 16 cells with four particles each, numbered at random, in two stretching modes.
auto shuffled(bool shuffle = true) {
    Problem<2, Musl, NeoHookean, Quadratic> s;
    s.add({0.4, 0.3, 1.0}, 16, 2, 4, 26, 0.5);
    for (auto& p : s.points()) p.v = Vec<2>(0.05 + 0.02 * std::sin(p.X[0]), 0.1 - 0.02 * std::cos(0.7 * p.X[1]) * std::sin(0.3 * p.X[0]));
    std::mt19937 random(3);
    if (shuffle) std::shuffle(s.points().begin(), s.points().end(), random);
    return s;
}

TEST(CellOrder, SortsByCellAndKeepsTheOrderWithin) {
    auto s = shuffled();
    auto& body = s.bodies[0];
    const auto before = body.points;
    ASSERT_TRUE(body.order.sort(body));
    const auto cell = [&](const auto& p) { return std::pair(std::floor(p.x[1] / 0.5), std::floor(p.x[0] / 0.5)); };
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(body.points[i].x, before[body.number(i)].x);
        if (i == 0) continue;
        EXPECT_LE(cell(body.points[i - 1]), cell(body.points[i]));
        if (cell(body.points[i - 1]) == cell(body.points[i])) {
            EXPECT_LT(body.number(i - 1), body.number(i));
        }
    }
}

TEST(CellOrder, NumbersSurviveManySorts) {
    auto s = shuffled();
    auto& body = s.bodies[0];
    const auto start = body.points;
    for (int k = 0; k < 5; ++k) {
        body.order.sort(body);
        s.run(40, 0.1);
    }
    for (std::size_t i = 0; i < start.size(); ++i) EXPECT_EQ(body.points[i].X, start[body.number(i)].X);
}

TEST(CellOrder, ChangesResultsByRoundingOnly) {
    auto plain = shuffled(), sorted = shuffled();
    auto& body = sorted.bodies[0];
    for (int k = 0; k < 200; ++k) {
        if (k % 7 == 0) body.order.sort(body);
        plain.run(1, 0.1);
        sorted.run(1, 0.1);
    }
    for (std::size_t i = 0; i < body.points.size(); ++i) {
        const auto &p = body.points[i], &q = plain.points()[body.number(i)];
        ASSERT_LT((p.x - q.x).norm(), 1e-12);  // 200 steps with about 50 roundings each on values of order one to ten
        ASSERT_LT((p.v - q.v).norm(), 1e-12);
        ASSERT_LT((p.sigma - q.sigma).norm(), 1e-12);
    }
}

TEST(CellOrder, WorksWithThreads) {
    auto one = shuffled(), two = shuffled();
    two.bodies[0].grid.use_threads(2);
    for (int k = 0; k < 60; ++k)
        for (auto* s : {&one, &two}) {
            if (k % 7 == 0) s->bodies[0].order.sort(s->bodies[0]);
            s->run(1, 0.1);
        }
    ASSERT_EQ(one.bodies[0].numbers, two.bodies[0].numbers);
    for (std::size_t i = 0; i < one.points().size(); ++i) ASSERT_LT((one.points()[i].x - two.points()[i].x).norm(), 1e-12);
}

TEST(CellOrder, IsKeptWhereItPays) {
    auto in_rows = shuffled(false), in_disorder = shuffled();
    auto &rows = in_rows.bodies[0], &disorder = in_disorder.bodies[0];
    EXPECT_FALSE(rows.order.keep(rows));  // neighbours in memory are neighbours in space
    EXPECT_TRUE(disorder.order.keep(disorder));
    for (long k = 0; k < 3 * disorder.order.every; ++k) EXPECT_FALSE(disorder.order.keep(disorder));
}

TEST(CellOrder, LeavesABodyWithAStrayParticleAlone) {
    auto s = shuffled();
    auto& body = s.bodies[0];
    body.points[100].x[0] = std::nan("");
    body.points[1].x[1] = -3;
    EXPECT_FALSE(body.order.keep(body));
    EXPECT_TRUE(body.numbers.empty());
}

struct AnyScene {};
struct ByNumber {
    static constexpr bool numbered = true;
};
TEST(CellOrder, IsNotForTotalLagrangianBodiesNorForScenesThatNumberParticles) {
    using Updated = Problem<2, Musl, LinearElastic>::BodyType;
    static_assert(may_reorder<Updated, AnyScene>);
    static_assert(!may_reorder<Updated, ByNumber>);
    static_assert(!may_reorder<Problem<2, Tlmpm, LinearElastic>::BodyType, AnyScene>);
    static_assert(!may_reorder<Problem<1, Musl, LinearElastic>::BodyType, AnyScene>);
}

std::string text(const std::string& path) {
    std::ostringstream s;
    s << std::ifstream(path).rdbuf();
    return s.str();
}
TEST(CellOrder, SnapshotsAndTroubleAreTheSame) {
    auto plain = shuffled(), sorted = shuffled();
    auto& body = sorted.bodies[0];
    body.order.sort(body);
    const std::string folder = testing::TempDir();
    using Bodies = std::remove_cvref_t<decltype(body)>;
    using Substance = Matter<2, Bodies::Point, Bodies::Node, Bodies::Law>;
    const auto of = [](Substance& one) { return particles_of<2>(std::vector<Substance*>{&one}); };
    write_csv(folder + "plain.csv", of(plain.bodies[0]));
    write_csv(folder + "sorted.csv", of(body));
    EXPECT_EQ(text(folder + "plain.csv"), text(folder + "sorted.csv"));
    const auto fastest = [](const auto& one) { return fastest_particle(std::array{&one}); };
    EXPECT_EQ(fastest(plain.bodies[0]), fastest(body));
    for (auto* s : {&plain, &sorted})
        for (std::size_t i = 0; i < s->points().size(); ++i)
            if (s->bodies[0].number(i) == 40 || s->bodies[0].number(i) == 700) s->points()[i].V = -1;
    const Trouble trouble = check_particles(body);
    EXPECT_EQ(trouble.reason.rfind("particle 40 at", 0), 0u) << trouble.reason;
    EXPECT_EQ(trouble.reason, check_particles(plain.bodies[0]).reason);
    body.grid.use_threads(3);
    EXPECT_EQ(trouble.reason, check_particles(body).reason);
}

/// More particles than the pieces of a sum, and an even number of them.
TEST(Monitor, SumsTheSameForAnyNumberOfThreads) {
    Problem<2, Musl, LinearElastic> s;
    s.add({0.4, 0.3, 1.0}, 60, 2, 2, 64, 0.5);
    for (auto& p : s.points()) p.v = Vec<2>(std::sin(p.X[0]), p.X[1] * p.X[0]), p.sigma(0, 1) = p.sigma(1, 0) = p.X[0];
    const Measures one = measure(s.bodies);
    double kinetic = 0;
    for (const auto& p : s.points()) kinetic += 0.5 * p.m * p.v.squaredNorm();
    EXPECT_NEAR(one.kinetic, kinetic, 1e-12 * kinetic);  // 14400 terms in two orders
    for (const int threads : {2, 3, 5}) {
        s.bodies[0].grid.use_threads(threads);
        const Measures many = measure(s.bodies);
        EXPECT_EQ(many.kinetic, one.kinetic);
        EXPECT_EQ(many.strain, one.strain);
        EXPECT_EQ(many.momentum, one.momentum);
        EXPECT_EQ(many.momentum_in_play, one.momentum_in_play);
    }
}

}  // namespace
}  // namespace mpm::test
