// compare with the programs of this build: what it finds without being told.
#include <gtest/gtest.h>

#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

TEST(CompareBars, FindsTheProgramsBesideItAndTheirOrder) {
    const Folder folder;
    const Ending ending = folder.run("compare", {"--cells", "10,20", "--plot", "none", "--", "tlmpm_bar", "--periods", "2"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(folder.has("out/compare/tlmpm_bar_periods-2/compare.csv"));
    const auto table = csv(folder.read("out/compare/tlmpm_bar_periods-2/compare.csv"));
    ASSERT_GE(table.size(), 4u);
    double order = 0;
    for (std::size_t row = 1; row < table.size(); ++row)
        if (field(table, row, "error_name") == "frequency") order = std::stod(field(table, row, "order"));
    EXPECT_NEAR(order, 2, 0.3);
}
TEST(CompareBars, CommandsAreThoseOfAnOrdinaryRun) {
    const Folder folder;
    const Ending list = folder.run("compare", {"--cells", "10", "--out", "all", "--list", "--", "tlmpm_bar", "--periods", "1"});
    EXPECT_EQ(list.code, 0) << list.err;
    EXPECT_TRUE(list.out.starts_with(std::string(MPM_BUILD_DIR) + "/tlmpm_bar --periods 1 --cells 10 --plot none --quiet --out "))
        << list.out;
}

}  // namespace
}  // namespace mpm::test
