// compare: what it stacks, draws and prints of runs that go well and of runs that do not.
#include <gtest/gtest.h>

#include "lab/table.hpp"
#include "tests/plots/fakes.hpp"

namespace mpm::test {
namespace {

Words row_of(const std::vector<Words>& table, const Words& columns, std::size_t row) {
    Words values;
    for (const std::string& column : columns) values.push_back(field(table, row, column));
    return values;
}

TEST(Compare, StacksTheRowsOfAllVariants) {
    const Fakes fakes;
    const Ending ending = fakes.tool("compare", {"--cells", "10,20,40", "--out", "all", "--", "good", "--mode", "3", "--", "better"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_EQ(ending.err, "");
    const auto table = csv(fakes.read("all/compare.csv"));
    EXPECT_EQ(table[0], summary_columns());
    ASSERT_EQ(table.size(), 13u);  // 2 variants, 3 resolutions, 2 errors
    EXPECT_EQ(row_of(table, {"program", "cells", "error_name", "options"}, 1), (Words{"good", "10", "size", "cells=10;mode=1,2"}));
    EXPECT_EQ(row_of(table, {"program", "cells", "error_name", "options"}, 12), (Words{"better", "40", "shape", "cells=40;mode=1,2"}));
    EXPECT_EQ(fakes.runs(), 6);
}
TEST(Compare, FillsOrdersWithinAVariantAndAnError) {
    const Fakes fakes;
    fakes.tool("compare", {"--cells", "10,20", "--out", "all", "--", "good", "--", "better"});
    const auto table = csv(fakes.read("all/compare.csv"));
    EXPECT_EQ(field(table, 1, "order"), "nan");
    EXPECT_NEAR(std::stod(field(table, 3, "order")), 2, 1e-12);
    EXPECT_NEAR(std::stod(field(table, 4, "order")), 2, 1e-12);
    EXPECT_EQ(field(table, 5, "order"), "nan");  // the first of the next variant
    EXPECT_NEAR(std::stod(field(table, 7, "order")), 3, 1e-12);
}
TEST(Compare, KeepsTheMethodsTimeAndMeasuresMemoryItself) {
    const Fakes fakes;
    fakes.tool("compare", {"--cells", "10", "--out", "all", "--", "good"});
    const auto table = csv(fakes.read("all/compare.csv"));
    EXPECT_EQ(field(table, 1, "wall_s"), "0.01");
    EXPECT_NE(field(table, 1, "peak_rss_kb"), "1234");  // which the fake claims
    EXPECT_GT(std::stol(field(table, 1, "peak_rss_kb")), 100);
}
TEST(Compare, PrintsTableOrdersAndWhenAnErrorWasReached) {
    const Fakes fakes;
    const Ending ending = fakes.tool(
        "compare", {"--cells", "10,20,40", "--out", "all", "--", "good", "--shape", "cubic", "--mode", "3", "--", "good", "--mode", "3"});
    EXPECT_TRUE(holds(ending.out, "good, cubic")) << ending.out;  // not the mode, which both have
    EXPECT_FALSE(holds(ending.out, "mode")) << ending.out;
    EXPECT_TRUE(holds(ending.out, "2.00  fitted")) << ending.out;
    EXPECT_TRUE(holds(ending.out, "good reached 1 % in 0.01 s (10 cells), 0.1 % in 0.04 s (40 cells)\n")) << ending.out;
}
TEST(Compare, LooksAtTheErrorThatIsNamed) {
    const Fakes fakes;
    EXPECT_EQ(fakes.tool("compare", {"--cells", "10", "--error", "shape", "--out", "all", "--", "good"}).code, 0);
    const auto table = csv(fakes.read("all/errors.csv"));
    EXPECT_EQ(row_of(table, {"name", "cells", "error_name", "error"}, 1), (Words{"good", "10", "shape", "0.005"}));
}
TEST(Compare, DrawsItsFigures) {
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) GTEST_SKIP() << "gnuplot is not installed";
    const Fakes fakes;
    const Ending ending = fakes.run("compare", {"--programs", "bin", "--cells", "10,20,100", "--history", "v_cm", "--out", "all", "--",
                                                "good", "--", "unstable", "--", "fails"});
    EXPECT_EQ(ending.err, "");
    for (const char* name : {"work_precision", "convergence", "history_v_cm"})
        for (const char* end : {".gp", ".png"}) EXPECT_TRUE(fakes.has(std::string("all/") + name + end)) << name << end;
    const std::string script = fakes.read("all/convergence.gp");
    EXPECT_TRUE(holds(script, "'good' . '}' . ': order 2.00'")) << script;  // bold: no other is as good and as fast
    EXPECT_TRUE(holds(script, "(1 of 3 unstable: energy-growth)")) << script;
    EXPECT_TRUE(holds(script, "(3 of 3 failed: exit 1)")) << script;
    EXPECT_TRUE(holds(fakes.read("all/history_v_cm.gp"), "v_cm_exact"));
}

TEST(Compare, ListsTheRunsThatNoneBeats) {
    const Fakes fakes;
    fakes.tool("compare", {"--cells", "10,20", "--out", "all", "--", "good", "--", "better"});  // each takes cells/1000 s
    const auto table = csv(fakes.read("all/front.csv"));
    ASSERT_EQ(table.size(), 3u);
    EXPECT_EQ(row_of(table, {"name", "cells"}, 1), (Words{"better", "10"}));
    EXPECT_EQ(row_of(table, {"name", "cells"}, 2), (Words{"better", "20"}));
}
TEST(Compare, DrawsWhatItIsTold) {
    const Fakes fakes;
    fakes.tool("compare",
               {"--cells", "10,20", "--title", "Both", "--error-label", "miss [-]", "--clock", "cpu", "--out", "all", "--", "good"});
    const std::string script = fakes.read("all/work_precision.gp");
    for (const char* text : {"set title 'Both'", "'miss [-]'", "CPU time of the method [s]; marks: 10, 20 cells"})
        EXPECT_TRUE(holds(script, text)) << text;
}

TEST(CompareBadRuns, AreRowsAndDoNotStopTheSweep) {
    const Fakes fakes;
    const Words bad{"fails", "crashes", "killed", "silent", "half", "strange"};
    Words words{"--cells", "10", "--out", "all"};
    for (const std::string& name : bad) words.insert(words.end(), {"--", name, "--mode", "2"});
    words.insert(words.end(), {"--", "good"});
    const Ending ending = fakes.tool("compare", words);
    EXPECT_EQ(ending.code, 3);
    EXPECT_EQ(ending.err, "");
    const auto table = csv(fakes.read("all/compare.csv"));
    ASSERT_EQ(table.size(), 9u);
    const Words verdicts{"failed:exit 1",     "failed:signal 11",  "failed:signal 9",
                         "failed:no summary", "failed:no summary", "failed:no summary"};
    for (std::size_t i = 0; i < bad.size(); ++i)
        EXPECT_EQ(row_of(table, {"program", "options", "cells", "error_name", "error", "verdict"}, i + 1),
                  (Words{bad[i], "mode=2", "10", "none", "nan", verdicts[i]}));
    EXPECT_EQ(field(table, 1, "reason"), "no good, at all");
    EXPECT_TRUE(holds(field(table, 6, "reason"), "columns")) << field(table, 6, "reason");
    EXPECT_EQ(row_of(table, {"program", "verdict"}, 7), (Words{"good", "ok"}));
}
TEST(CompareBadRuns, ThatTakeTooLongAreKilled) {
    const Fakes fakes;
    EXPECT_EQ(fakes.tool("compare", {"--cells", "10", "--timeout", "0.3", "--out", "all", "--", "hangs", "--", "good"}).code, 3);
    const auto table = csv(fakes.read("all/compare.csv"));
    EXPECT_EQ(field(table, 1, "verdict"), "failed:timeout");
    EXPECT_EQ(field(table, 2, "verdict"), "ok");
}
TEST(CompareBadRuns, ThatBecomeUnstableHaveNoErrorAndNoOrder) {
    const Fakes fakes;
    const Ending ending = fakes.tool("compare", {"--cells", "50,100,200", "--out", "all", "--", "unstable"});
    EXPECT_EQ(ending.code, 3);
    EXPECT_TRUE(holds(ending.out, "energy grew from 1 to 2, twice")) << ending.out;
    const auto table = csv(fakes.read("all/compare.csv"));
    ASSERT_EQ(table.size(), 7u);
    EXPECT_EQ(row_of(table, {"error", "order", "verdict", "t_fail"}, 3), (Words{"nan", "nan", "unstable:energy-growth", "0.5"}));
}

}  // namespace
}  // namespace mpm::test
