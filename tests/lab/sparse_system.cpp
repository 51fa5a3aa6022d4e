#include "lab/sparse_system.hpp"

#include <gtest/gtest.h>

namespace mpm {
namespace {

/// A chain of springs, its first end held; elements of two unknowns and one of one.
void fill(SparseSystem& system) {
    const double spring[] = {1, -1, -1, 1}, single[] = {5};
    system.use(4, {{-1, 0}, {0, 1}, {1, 2}, {3}});
    system.clear();
    for (int e = 0; e < 3; ++e) system.add(e, spring);
    system.add(3, single);
}

TEST(SparseSystem, SolvesAChainOfSprings) {
    for (const bool symmetric : {true, false}) {
        SparseSystem system(symmetric);
        fill(system);
        std::vector<double> x;
        ASSERT_TRUE(system.solve({0, 0, 1, 10}, x));
        const double exact[] = {1, 2, 3, 2};
        for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(x[i], exact[i], 1e-14);
    }
}
TEST(SparseSystem, AnalysesAPatternOnce) {
    SparseSystem system;
    std::vector<double> x;
    for (int n = 0; n < 3; ++n) fill(system), system.solve({0, 0, 1, 10}, x);
    EXPECT_EQ(system.analyses(), 1);
    EXPECT_EQ(system.factorisations(), 3);
    system.use(2, {{0, 1}});
    EXPECT_EQ(system.analyses(), 2);
}
TEST(SparseSystem, SaysThatASystemIsSingular) {
    for (const bool symmetric : {true, false}) {
        SparseSystem system(symmetric);
        const double spring[] = {1, -1, -1, 1};
        system.use(2, {{0, 1}});
        system.clear();
        system.add(0, spring);
        std::vector<double> x;
        EXPECT_FALSE(system.solve({1, 1}, x));
    }
}

}  // namespace
}  // namespace mpm
