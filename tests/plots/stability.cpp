// stability: the largest step of a program whose limit is known, and what it leaves out.
#include <gtest/gtest.h>

#include "tests/plots/fakes.hpp"

namespace mpm::test {
namespace {

/// The row of a program's case.
std::size_t row_of(const std::vector<Words>& table, const std::string& program, const std::string& name) {
    for (std::size_t i = 1; i < table.size(); ++i)
        if (field(table, i, "program") == program && field(table, i, "case") == name) return i;
    throw std::runtime_error("no row " + program + " " + name);
}

TEST(Stability, FindsTheLargestStep) {
    const Fakes fakes;
    const Ending ending = fakes.tool("stability", {"--quick", "--out", "all", "--", "limited"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    const auto table = csv(fakes.read("all/stability.csv"));
    const double stable = std::stod(field(table, row_of(table, "limited", "largest-step"), "fraction"));
    EXPECT_LE(stable, 0.7);
    EXPECT_GT(stable, 0.7 / 1.01);
    const std::size_t beyond = row_of(table, "limited", "step-beyond");
    EXPECT_GT(std::stod(field(table, beyond, "fraction")), 0.7);
    EXPECT_EQ(field(table, beyond, "verdict"), "unstable:energy-growth");
    EXPECT_TRUE(holds(ending.out, "(then energy-growth)")) << ending.out;
}
TEST(Stability, LeavesOutWhatAProgramCannotRunAndSaysSo) {
    const Fakes fakes;
    const Ending ending = fakes.tool("stability", {"--quick", "--out", "all", "--", "limited"});
    EXPECT_TRUE(holds(ending.out, "left out, no program has contrast")) << ending.out;
    EXPECT_TRUE(holds(ending.out, "left out, no program has offset")) << ending.out;
    const auto table = csv(fakes.read("all/stability.csv"));
    EXPECT_EQ(field(table, row_of(table, "limited", "tiny-mass"), "verdict"), "left out");
    EXPECT_EQ(field(table, row_of(table, "limited", "contrast"), "verdict"), "ok");  // a contrast of 1 needs no option
}
TEST(Stability, NamesTheInstabilityOfACase) {
    const Fakes fakes;
    const Ending ending = fakes.tool("stability", {"--quick", "--out", "all", "--", "unstable"});
    EXPECT_EQ(ending.code, 0) << ending.err;  // an instability is what it looks for
    EXPECT_TRUE(holds(fakes.read("all/stability_map.csv"), ",unstable,"));
    const auto table = csv(fakes.read("all/stability.csv"));
    EXPECT_EQ(field(table, row_of(table, "unstable", "fine"), "verdict"), "unstable:energy-growth");
    EXPECT_TRUE(holds(ending.out, "(the largest tried)")) << ending.out;
}
TEST(Stability, FailuresAreRowsAndExitWithThree) {
    const Fakes fakes;
    EXPECT_EQ(fakes.tool("stability", {"--quick", "--out", "all", "--", "fails", "--", "crashes", "--", "limited"}).code, 3);
    const auto table = csv(fakes.read("all/stability.csv"));
    EXPECT_EQ(field(table, row_of(table, "fails", "step-beyond"), "verdict"), "failed:exit 1");
    EXPECT_EQ(field(table, row_of(table, "crashes", "fine"), "verdict"), "failed:signal 11");
    EXPECT_EQ(field(table, row_of(table, "limited", "fine"), "verdict"), "ok");
}
TEST(Stability, DrawsItsFigures) {
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) GTEST_SKIP() << "gnuplot is not installed";
    const Fakes fakes;
    const Ending ending =
        fakes.run("stability", {"--programs", "bin", "--quick", "--out", "all", "--", "limited", "--", "unstable", "--mode", "2"});
    EXPECT_EQ(ending.err, "");
    for (const char* name : {"stability_steps", "stability_map"})
        for (const char* end : {".csv", ".gp", ".png"}) EXPECT_TRUE(fakes.has(std::string("all/") + name + end)) << name << end;
}
TEST(Stability, RefusesContrastsThatAreNotNumbers) {
    const Fakes fakes;
    for (const char* bad : {"", "1,", "a", "1,-2", "inf"})
        expect_one_line(fakes.tool("stability", {"--contrast", bad, "--", "limited"}), 2, {"--contrast", "numbers > 0"});
    EXPECT_FALSE(fakes.has("out"));
}

}  // namespace
}  // namespace mpm::test
