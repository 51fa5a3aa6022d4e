// The schemes in several threads: after 200 steps in which particles cross cells and strips, the state of one thread to rounding, the same
// bits for every number of threads above one and on repetition.
#include <gtest/gtest.h>

#include "tests/chapters/explicit/problem.hpp"

namespace mpm::test {
namespace {

template <class S, class K> struct With {
    using Scheme = S;
    using Kernel = K;
};
template <class Case> class ThreadsOf : public testing::Test {};
using Cases = testing::Types<With<Usl, Cubic>, With<Usl, Cpgimp>, With<Usf, Hat>, With<Usf, Cubic>, With<Musl, Hat>, With<Musl, Quadratic>,
                             With<Musl, Cubic>, With<Musl, Cpgimp>, With<Tlmpm, Hat>, With<Tlmpm, Bernstein>>;
TYPED_TEST_SUITE(ThreadsOf, Cases);

/// A drifting square in two stretching modes, 16 x 16 cells with 2 x 2 particles each, c = 1.
template <class Scheme, class Kernel> auto drifting(int threads) {
    Problem<2, Scheme, NeoHookean, Kernel> s;
    s.add({0.4, 0.3, 1.0}, 16, 2, 4, 26, 0.5);
    for (auto& p : s.points()) p.v = Vec<2>(0.05 + 0.02 * std::sin(p.X[0]), 0.1 - 0.02 * std::cos(0.7 * p.X[1]) * std::sin(0.3 * p.X[0]));
    s.bodies[0].grid.use_threads(threads);
    s.run(200, 0.1);
    return s.points();
}

TYPED_TEST(ThreadsOf, StateIsThatOfOneThread) {
    using Scheme = typename TypeParam::Scheme;
    using Kernel = typename TypeParam::Kernel;
    const auto one = drifting<Scheme, Kernel>(1), two = drifting<Scheme, Kernel>(2);
    const double tolerance = 1e-12;  // 200 steps with about 50 roundings each on values of order one to ten
    for (std::size_t i = 0; i < one.size(); ++i) {
        ASSERT_LT((one[i].x - two[i].x).norm(), tolerance);
        ASSERT_LT((one[i].v - two[i].v).norm(), tolerance);
        ASSERT_LT((one[i].F - two[i].F).norm(), tolerance);
        ASSERT_LT((one[i].sigma - two[i].sigma).norm(), tolerance);
    }
    EXPECT_GT(one[0].x[1] - one[0].X[1], 1.0);  // two cells and more
    for (const int threads : {2, 3}) {
        const auto many = drifting<Scheme, Kernel>(threads);
        for (std::size_t i = 0; i < two.size(); ++i) {
            ASSERT_EQ(many[i].x, two[i].x) << threads << " threads";
            ASSERT_EQ(many[i].v, two[i].v) << threads << " threads";
            ASSERT_EQ(many[i].sigma, two[i].sigma) << threads << " threads";
        }
    }
}

}  // namespace
}  // namespace mpm::test
