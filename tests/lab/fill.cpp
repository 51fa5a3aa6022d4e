// The points of a cell: middles of equal parts, and Gauss-Legendre points.
#include "lab/fill.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace mpm::test {
namespace {

double integral(const CellRule& rule, int power) {
    double sum = 0;
    for (std::size_t q = 0; q < rule.at.size(); ++q) sum += rule.part[q] * std::pow(rule.at[q], power);
    return sum;
}

TEST(Middles, AreEqualParts) {
    const CellRule rule = middles(4);
    EXPECT_EQ(rule.at, (std::vector<double>{0.125, 0.375, 0.625, 0.875}));
    EXPECT_EQ(rule.part, std::vector<double>(4, 0.25));
}

TEST(GaussPoints, AreTheKnownOnes) {
    const CellRule one = gauss_points(1), two = gauss_points(2), three = gauss_points(3);
    EXPECT_NEAR(one.at[0], 0.5, 1e-16);
    EXPECT_NEAR(one.part[0], 1, 1e-15);
    for (const std::size_t q : {0, 1}) {
        EXPECT_NEAR(two.at[q], 0.5 + (q == 0 ? -0.5 : 0.5) / std::sqrt(3), 1e-15);
        EXPECT_NEAR(two.part[q], 0.5, 1e-15);
    }
    for (const std::size_t q : {0, 1, 2}) {
        EXPECT_NEAR(three.at[q], 0.5 + 0.5 * (static_cast<double>(q) - 1) * std::sqrt(0.6), 1e-15);
        EXPECT_NEAR(three.part[q], q == 1 ? 8.0 / 18 : 5.0 / 18, 1e-15);
    }
}

TEST(GaussPoints, IntegratePolynomialsUpToTwiceTheirNumber) {
    for (const int n : {1, 2, 3, 4, 5, 10, 30, 100}) {
        const CellRule rule = gauss_points(n);
        EXPECT_TRUE(std::is_sorted(rule.at.begin(), rule.at.end()));
        for (int power = 0; power < 2 * n; ++power) EXPECT_NEAR(integral(rule, power), 1.0 / (power + 1), 1e-14) << n << ' ' << power;
        if (n < 5) { EXPECT_GT(std::abs(integral(rule, 2 * n) - 1.0 / (2 * n + 1)), 1e-6) << "no better than stated"; }
    }
}

TEST(CellRule, IsFoundByName) {
    EXPECT_EQ(cell_rule("mid", 3).at, middles(3).at);
    EXPECT_EQ(cell_rule("gauss", 3).at, gauss_points(3).at);
}

}  // namespace
}  // namespace mpm::test
