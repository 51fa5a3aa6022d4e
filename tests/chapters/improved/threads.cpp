// The transfers in several threads give the state of one, and the same bits for every number of threads above one.
#include <gtest/gtest.h>

#include "chapters/improved/affine.hpp"
#include "chapters/improved/consistent.hpp"
#include "chapters/improved/fmpm.hpp"
#include "tests/chapters/explicit/problem.hpp"

namespace mpm::test {
namespace {

template <class Kernel, class Transfer> auto drifting(const Transfer& transfer, int threads, int steps) {
    Problem<2, Musl, LinearElastic, Kernel, Transfer> s;
    s.transfer = transfer;
    s.add({0.4, 0.3, 1.0}, 12, 2, 4, 22, 0.5);
    for (auto& p : s.points()) p.v = Vec<2>(0.05 + 0.02 * std::sin(p.X[0]), 0.1 - 0.02 * std::cos(0.7 * p.X[1]) * std::sin(0.3 * p.X[0]));
    s.bodies[0].grid.use_threads(threads);
    s.run(steps, 0.1);
    return s.points();
}

template <class Kernel = Quadratic, class Transfer> void expect_the_same(const Transfer& transfer, int steps = 200) {
    const auto one = drifting<Kernel>(transfer, 1, steps), two = drifting<Kernel>(transfer, 2, steps),
               three = drifting<Kernel>(transfer, 3, steps);
    for (std::size_t i = 0; i < one.size(); ++i) {
        ASSERT_LT((one[i].x - two[i].x).norm(), 1e-12);  // 200 steps with about 50 roundings each on values of order one to ten
        ASSERT_LT((one[i].v - two[i].v).norm(), 1e-12);
        ASSERT_LT((one[i].sigma - two[i].sigma).norm(), 1e-12);
        ASSERT_EQ(two[i].x, three[i].x);
        ASSERT_EQ(two[i].v, three[i].v);
    }
}

TEST(ThreadsOfTransfers, Apic) { expect_the_same(Apic<false>{}); }
TEST(ThreadsOfTransfers, Fmpm) { expect_the_same(Fmpm{3}); }
TEST(ThreadsOfTransfers, Xpic) { expect_the_same(xpic(2)); }
TEST(ThreadsOfTransfers, Pic) { expect_the_same(Flip{0}); }
/// A few steps: particles that hardly touch a node at the edge soon make the mass matrix all but singular.
TEST(ThreadsOfTransfers, ConsistentMass) { expect_the_same<Hat>(Consistent<false>{}, 3); }

}  // namespace
}  // namespace mpm::test
