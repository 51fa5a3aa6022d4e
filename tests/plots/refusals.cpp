// compare and stability: bad input is one line, exit code 2, and nothing is run or written.
#include <gtest/gtest.h>

#include "tests/plots/fakes.hpp"

namespace mpm::test {
namespace {

struct Refusal {
    std::string name;
    Words words, parts;
};

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, WithOneLineAndNothingRun) {
    const Fakes fakes;
    for (const char* tool : {"compare", "stability"}) {
        expect_one_line(fakes.tool(tool, GetParam().words), 2, GetParam().parts);
        EXPECT_EQ(fakes.runs(), 0);
        EXPECT_FALSE(fakes.has("out"));
    }
}

const std::vector<Refusal> refusals{
    {"NoVariants", {}, {"no variants", "-- usl_bar"}},
    {"NoProgram", {"--"}, {"a program is missing after --"}},
    {"UnknownProgram", {"--", "goood"}, {"unknown program goood", "did you mean good?"}},
    {"NotBuilt", {"--", "not_built"}, {"not_built is not built"}},
    {"UnknownOption", {"--", "good", "--mod", "3"}, {"good: unknown option --mod", "did you mean --mode?"}},
    {"NoValue", {"--", "good", "--mode"}, {"good: --mode needs a value"}},
    {"StrayWord", {"--", "good", "3"}, {"good: unexpected word '3'"}},
    {"Managed", {"--", "good", "--cells", "10"}, {"good: --cells is set"}},
    {"Twice", {"--", "good", "--mode", "3", "--", "good", "--mode=3"}, {"the same variant is given twice"}},
    {"BadValue", {"--", "strict", "--mode", "7"}, {"strict: --mode 7: not this one"}},
    {"Gridless", {"--", "gridless"}, {"gridless has no option --cells"}},
    {"OwnOption", {"--cels", "10", "--", "good"}, {"--cels", "did you mean --cells?"}},
    {"LabelWithSlash", {"--label", "a/b", "--", "good"}, {"--label a/b"}},
};
INSTANTIATE_TEST_SUITE_P(Plots, Refused, testing::ValuesIn(refusals), [](const auto& each) { return each.param.name; });

TEST(RefusedByCompare, UnknownErrorNameListsTheNames) {
    const Fakes fakes;
    expect_one_line(fakes.tool("compare", {"--cells", "10,20", "--error", "sise", "--quiet", "--out", "all", "--", "good"}), 2,
                    {"--error sise", "size, shape"});
    EXPECT_EQ(fakes.runs(), 1);  // seen at the first row
}
TEST(RefusedByCompare, UnknownHistoryListsTheColumns) {
    const Fakes fakes;
    expect_one_line(fakes.tool("compare", {"--cells", "10", "--history", "v", "--quiet", "--out", "all", "--", "good"}), 2,
                    {"--history v", "known are v_cm"});
}
TEST(RefusedByCompare, CollectTakesNeitherVariantsNorCells) {
    const Fakes fakes;
    expect_one_line(fakes.run("compare", {"--collect", "all", "--", "good"}), 2, {"--collect takes no variants"});
    expect_one_line(fakes.run("compare", {"--collect", "all", "--cells", "10"}), 2, {"--collect", "--cells"});
}
TEST(RefusedByCompare, CollectOfAnotherFolderIsFileTrouble) {
    const Fakes fakes;
    expect_one_line(fakes.run("compare", {"--collect", "bin"}), 1, {"bin/sweep.csv"});
}
TEST(RefusedByCompare, FolderWithoutProgramsIsFileTrouble) {
    const Fakes fakes;
    expect_one_line(fakes.run("compare", {"--programs", ".", "--", "good"}), 1, {"programs.txt"});
}

}  // namespace
}  // namespace mpm::test
