// The CPDI programs as a user runs them: the heavy column (NUMBERS section 20), the hole (review 3.7), bar and segment.
#include <algorithm>
#include <cmath>

#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

struct Outcome {
    Ending ending;
    std::vector<Words> summary, history;
    double error(std::size_t row) const { return std::stod(field(summary, row, "error")); }
    double most(const std::string& column) const {
        double high = 0;
        for (std::size_t row = 1; row < history.size(); ++row) high = std::max(high, std::stod(field(history, row, column)));
        return high;
    }
    double last(const std::string& column) const { return std::stod(field(history, history.size() - 1, column)); }
};
Outcome outcome(const std::string& program, Words words, int code = 0) {
    const Folder folder;
    words.insert(words.end(), {"--quiet", "--out", "run"});
    Outcome o;
    o.ending = folder.run(program, words);
    EXPECT_EQ(o.ending.code, code) << program << ": " << o.ending.err;
    o.summary = csv(folder.read("run/summary.csv"));
    if (folder.has("run/history.csv")) o.history = csv(folder.read("run/history.csv"));
    return o;
}

// Reference: R4 .2874, Q4 .2874, T3 .2868 at h = 1/16 and g = 250. Half a thousandth is what the choice of the tip's place and a record
// every 1.25e-4 leave open; polygons have no reference and differ from the others by less than 1 %.
TEST(HeavyColumn, SwingsAsFarAsTheReference) {
    const Words words{"--cfl", "0.3", "--t-end", "0.075"};
    const double r4 = outcome("cpdi_r4_column", words).most("tip"), q4 = outcome("cpdi_q4_column", words).most("tip");
    const double t3 = outcome("cpdi_t3_column", words).most("tip"), polygon = outcome("cpdi_polygon_column", words).most("tip");
    EXPECT_NEAR(r4, 0.2874, 5e-4);
    EXPECT_NEAR(q4, 0.2874, 5e-4);
    EXPECT_NEAR(t3, 0.2868, 5e-4);
    EXPECT_NEAR(t3 / q4, 1, 0.01);
    EXPECT_NEAR(polygon / q4, 1, 0.01);
}
// Reference: Q4 1.5793, T3 1.5806. Polygons of 3 x 3 in a cell: at 2 x 2 some span more than three cells, and the run says so.
TEST(HeavyColumn, SwingsAsFarAsTheReferenceInStrongGravity) {
    const Words words{"--g", "1000", "--cfl", "0.3", "--t-end", "0.1"};
    Words finer = words;
    finer.insert(finer.end(), {"--ppc", "3"});
    const double q4 = outcome("cpdi_q4_column", words).most("tip"), t3 = outcome("cpdi_t3_column", words).most("tip");
    EXPECT_NEAR(q4, 1.5793, 1e-3);
    EXPECT_NEAR(t3, 1.5806, 1e-3);
    EXPECT_NEAR(outcome("cpdi_polygon_column", finer).most("tip") / q4, 1, 0.01);
}
// Where R4 breaks at g = 1000 (reference: in the top row): a domain there is stretched over three cells, and the run ends with that name.
TEST(HeavyColumn, BreaksWithParallelogramsAndSaysWhere) {
    const Outcome o = outcome("cpdi_r4_column", {"--g", "1000", "--cfl", "0.3"}, 3);
    EXPECT_EQ(field(o.summary, 1, "verdict"), "unstable:domain-trouble");
    const std::string reason = field(o.summary, 1, "reason"), start = "the domain of particle ";
    ASSERT_TRUE(holds(reason, start)) << reason;
    EXPECT_GE(std::stoi(reason.substr(reason.find(start) + start.size())), 31 * 32) << reason;  // 32 rows of 32, from below
    EXPECT_LT(std::stod(field(o.summary, 1, "t_fail")), 0.1);
}

// R4 .0082 and .0039 of the area are gaps at h = 1/4, 1/8, overlaps .0064 and .0029, told without moment and measure: within a factor 1.6
// of that, and half as much on the finer grid, as F differs half as much from one domain to the next. Domains with common corners have
// none.
TEST(HeavyColumn, OpensGapsBetweenParallelogramsOnly) {
    const Words coarse{"--cells", "4", "--t-end", "0.08"}, fine{"--cells", "8", "--t-end", "0.08"};
    const Outcome r4 = outcome("cpdi_r4_column", coarse), finer = outcome("cpdi_r4_column", fine);
    EXPECT_NEAR(std::log(r4.most("gap") / 0.0082), 0, std::log(1.6));
    EXPECT_NEAR(std::log(r4.most("overlap") / 0.0064), 0, std::log(1.6));
    EXPECT_NEAR(std::log(finer.most("gap") / 0.0039), 0, std::log(1.6));
    EXPECT_NEAR(std::log(finer.most("overlap") / 0.0029), 0, std::log(1.6));
    EXPECT_NEAR(r4.most("gap") / finer.most("gap"), 2, 0.4);
    for (const char* program : {"cpdi_q4_column", "cpdi_t3_column", "cpdi_polygon_column"}) {
        const Outcome shared = outcome(program, coarse);
        EXPECT_EQ(shared.most("gap"), 0) << program;
        EXPECT_LT(shared.most("overlap"), 1e-12) << program;  // rounding of sums of 64 areas and more
    }
}

// The state of rest is exact: second order. The damping is a friction; what it leaves of the motion keeps the observed order a little under
// 2.
TEST(HeavyColumn, ComesToRestAtTheExactStretchWithHeldSides) {
    for (const char* program : {"cpdi_q4_column", "cpdi_t3_column", "cpdi_polygon_column"}) {
        const Words words{"--sides", "held", "--damping", "0.5", "--t-end", "2", "--cells", "4,8",
                          "--g",     "1000", "--cfl",     "0.3", "--records", "10"};
        const Outcome o = outcome(program, words);
        EXPECT_LT(o.error(1), 3e-3) << program;
        EXPECT_LT(o.error(2), 1e-3) << program;
        EXPECT_GT(std::log2(o.error(1) / o.error(2)), 1.5) << program;
    }
}
// Weights of the start, on a grid that stays: no cell is crossed, nothing is stretched too far.
TEST(HeavyColumn, HangsInTotalLagrangianFormToo) {
    const Outcome o = outcome("cpdi_q4_column", {"--g", "1000", "--scheme", "tlmpm", "--cfl", "0.3", "--t-end", "0.1"});
    EXPECT_NEAR(o.most("tip"), 1.5793, 0.01 * 1.5793);
}

TEST(CpdiHole, IsNamedWithItsRemedy) {
    const Outcome o = outcome("cpdi_hole", {}, 3);
    EXPECT_EQ(field(o.summary, 1, "verdict"), "unstable:domain-trouble");
    const std::string reason = field(o.summary, 1, "reason");
    EXPECT_TRUE(holds(reason, "the domain of particle 1 ") && holds(reason, "split it")) << reason;
}
// Figure 32 (a): it keeps its velocity to the last digit but for rounding, and so does the wide one its rest.
TEST(CpdiHole, LetsTheSmallParticleThrough) {
    const Outcome o = outcome("cpdi_hole", {"--watch", "warn"}, 3);
    EXPECT_NEAR(o.last("y_small"), 1.5, 1e-10);
    EXPECT_NEAR(o.last("v_wide"), 0, 1e-12);
}
// Figure 32 (b), and what splitting does: the small one stays above, the wide one is pushed.
TEST(CpdiHole, IsClosedByShorterDomains) {
    for (const Words& words : {Words{"--wide", "2.8"}, Words{"--split"}}) {
        const Outcome o = outcome("cpdi_hole", words);
        EXPECT_GT(o.last("y_small"), o.last("y_wide") + 0.8) << words[0];
        EXPECT_LT(o.last("y_wide"), 3.2) << words[0];
    }
    EXPECT_EQ(field(outcome("cpdi_hole", {"--split"}).summary, 1, "verdict"), "ok");
}

// Second order, as cpGIMP with USL (8.2e-5 at h = 1/64, NUMBERS section 3), whether corners move with the grid or with F: with USL that is
// the same in one dimension. (MUSL moves particles with one velocity and strains them with another: there domains that F carries part.)
TEST(CpdiLine, IsOfSecondOrderOnTheSegment) {
    const Words words{"--cells", "32,64", "--G", "0.05", "--ppc", "2"};
    Words carried = words;
    carried.insert(carried.end(), {"--corners", "F"});
    const Outcome grid = outcome("cpdi_segment", words), F = outcome("cpdi_segment", carried);
    const std::size_t names = (grid.summary.size() - 1) / 2;  // rows of a resolution, e1 first
    EXPECT_NEAR(std::log2(grid.error(1) / grid.error(1 + names)), 2, 0.05);
    EXPECT_NEAR(grid.error(1 + names) / 8.2e-5, 1, 0.1);
    EXPECT_NEAR(F.error(1 + names) / grid.error(1 + names), 1, 1e-9);
}
TEST(CpdiLine, KeepsTheFrequencyOfTheBar) {
    const Outcome grid = outcome("cpdi_bar", {"--cells", "25"}), F = outcome("cpdi_bar", {"--cells", "25", "--corners", "F"});
    EXPECT_LT(grid.error(1), 1e-3);
    EXPECT_NEAR(F.error(1), grid.error(1), 1e-9);
}

}  // namespace
}  // namespace mpm::test
