// Programs of implicit MPM as a user runs them.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

double number(const std::vector<Words>& table, std::size_t row, const std::string& column) { return std::stod(field(table, row, column)); }
std::vector<Words> summary(const std::string& program, Words words) {
    const Folder folder;
    words.insert(words.end(), {"--quiet", "--records", "20", "--out", "run"});
    EXPECT_EQ(folder.run(program, words).code, 0);
    return csv(folder.read("run/summary.csv"));
}

// Steps to 1000 h/c against the closed form of Newmark's rule: 1e-6 up to 10 h/c, 2e-4 beyond; the invariant within 2e-5 over 1000 steps
// without crossings. What is left grows with the square of the strain (v0/c = 1e-5) and the displacement over h.
TEST(ImplicitBar, HasTheFrequencyAndTheInvariantOfNewmarksRule) {
    for (const std::string mode : {"1", "10"})
        for (const std::string beta : {"0.25", "0.3"})
            for (const double cfl : {0.1, 1.0, 10.0, 1000.0}) {
                const auto t_end = std::to_string(50 * std::max(1.0, cfl));  // h/c = 0.05
                const auto rows = summary("implicit_bar", {"--mode", mode, "--beta", beta, "--cfl", std::to_string(cfl), "--t-end", t_end});
                EXPECT_EQ(field(rows, 2, "error_name"), "newmark_frequency");
                EXPECT_LT(number(rows, 2, "error"), cfl > 10 ? 2e-4 : 1e-6) << mode << ' ' << beta << ' ' << cfl;
                EXPECT_LT(number(rows, 3, "error"), 2e-5) << mode << ' ' << beta << ' ' << cfl;
            }
}
TEST(ImplicitContrastBar, CostsTheSameForAnyStiffness) {
    for (const char* contrast : {"1", "1e4", "1e8"}) {
        const auto rows = summary("implicit_contrast_bar", {"--contrast", contrast});
        EXPECT_EQ(field(rows, 1, "steps"), "200");
        EXPECT_LT(number(rows, 1, "error"), 3e-4) << contrast;  // frequency on 32 cells: (beta h)^2/24
    }
}
// While particles stay in their cells the state of rest is off by a part of the strain, 7e-4: cells count V of their particles, not h.
TEST(ImplicitColumn, RestsWhereItMust) {
    const auto rows = summary("implicit_column", {"--cells", "10"});
    EXPECT_LT(number(rows, 1, "error"), 1e-3);
    EXPECT_LT(number(rows, 2, "error"), 0.05);  // stress is constant in a cell
}
TEST(ImplicitColumn, FollowsASlowLoadAtAnyStiffness) {
    for (const char* stiffer : {"1", "1e8"}) {
        const auto rows = summary("implicit_column", {"--cells", "10", "--stiffer", stiffer, "--ramp", "1", "--dt", "0.1"});
        EXPECT_EQ(field(rows, 1, "steps"), "20");
        EXPECT_LT(number(rows, 1, "error"), 1e-3) << stiffer;  // as above
    }
}
TEST(ImplicitCantilever, StiffEndCostsNoSteps) {
    for (const char* contrast : {"1", "1e4"}) {
        const auto rows = summary("implicit_cantilever", {"--contrast", contrast, "--g", "0.01", "--rows", "10", "--layers", "5", "--t-end", "1.6"});
        EXPECT_EQ(field(rows, 1, "steps"), "200");
        EXPECT_LT(number(rows, 1, "momentum_drift"), 1e-6) << contrast;  // Newton's 1e-10, of terms that grow with the contrast
    }
}
TEST(ImplicitCrossing, ConservingStepsKeepTheEnergyThroughAThousandCells) {
    const auto rows = summary("implicit_crossing", {"--carry", "conserving"});
    EXPECT_LT(number(rows, 1, "error"), 1e-5);  // gain; Newton's tolerance in each of 11,001 steps
    EXPECT_LT(number(rows, 2, "error"), 1e-5);  // change
}
TEST(ImplicitCrossing, ThePublishedFormBlowsUp) {
    const Folder folder;
    EXPECT_EQ(folder.run("implicit_crossing", {"--quiet", "--out", "run"}).code, 3);
    EXPECT_EQ(field(csv(folder.read("run/summary.csv")), 1, "verdict"), "unstable:energy-growth");
}
TEST(ImplicitRollingDisk, RollsDown) {
    const auto rows = summary("implicit_rolling_disk", {"--E", "4.2e8", "--around", "40", "--layers", "5", "--t-end", "0.4"});
    EXPECT_LT(number(rows, 1, "error"), 0.2);  // coarse and short; (52) falls with time
    EXPECT_LT(number(rows, 1, "momentum_drift"), 1e-8);
}
TEST(ImplicitPrograms, WriteTheirNewtonIterations) {
    const Folder folder;
    ASSERT_EQ(folder.run("implicit_column", {"--newton", "--quiet", "--out", "run"}).code, 0);
    const auto rows = csv(folder.read("run/newton.csv"));
    EXPECT_GT(rows.size(), 10u);
    EXPECT_EQ(field(rows, 1, "iteration"), "0");
}
TEST(ImplicitPrograms, RefuseWhatCannotBe) {
    const Folder folder;
    const std::vector<Words> wrong{
        {"--carry", "midpoint", "--beta", "0.3"}, {"--carry", "conserving", "--tangent", "analytic"}, {"--dt-from", "step"}};
    for (const Words& words : wrong) {
        const Ending end = folder.run("implicit_bar", words);
        EXPECT_EQ(end.code, 2);
        EXPECT_EQ(end.err.find('\n'), end.err.size() - 1) << end.err;
    }
    EXPECT_EQ(folder.run("implicit_rolling_disk", {"--cells", "50"}).code, 2);
    EXPECT_EQ(folder.run("implicit_cantilever", {"--ppc", "3"}).code, 2);
    EXPECT_EQ(folder.run("implicit_cantilever", {"--cells", "100000"}).code, 2);  // 4e10 nodes
}

}  // namespace
}  // namespace mpm::test
