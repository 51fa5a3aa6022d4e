// reliability: random settings keep to what a program describes, and every bad end is noticed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "plots/random_options.hpp"
#include "tests/plots/fakes.hpp"

namespace mpm::test {
namespace {

const std::vector<DescribedOption> described =
    described_options(parse_csv("name,type,default,low,high,choices\nE,number,100,0,,\nnu,number,0.3,-1,0.5,\ncells,integers,50,3,1000,"
                                "\nshape,choice,hat,,,hat|cubic\nquiet,flag,false,,,\n",
                                "test"));

bool fits(const std::string& name, const std::string& value) {
    const double x = std::atof(value.c_str());
    if (name == "E") return x >= 0;
    if (name == "nu") return x >= -1 && x <= 0.5;
    if (name == "cells") return x >= 3 && x <= 1000 && value.find_first_not_of("0123456789") == std::string::npos;
    return name == "shape" && (value == "hat" || value == "cubic");
}

TEST(RandomSettings, StayInTheRangesThatAreDescribed) {
    Random random(1);
    std::map<std::string, int> seen;
    for (int i = 0; i < 2000; ++i)
        for (const std::string& word : random_settings(described, random)) {
            const std::size_t is = word.find('=');
            ASSERT_NE(is, std::string::npos) << word;
            EXPECT_TRUE(fits(word.substr(2, is - 2), word.substr(is + 1))) << word;
            ++seen[word.substr(2, is - 2)];
        }
    EXPECT_EQ(seen.size(), 4u);  // all but --quiet, which the caller sets
    for (const auto& [name, times] : seen) EXPECT_GT(times, 500) << name;
}

Words results(const Fakes& fakes, const std::string& program, const std::string& kind) {
    fakes.run("reliability", {"--programs", "bin", "--runs", "3", "--only", program, "--timeout", "1", "--out", "all", "--quiet"});
    const auto table = csv(fakes.read("all/reliability.csv"));
    Words all;
    for (std::size_t row = 1; row < table.size(); ++row)
        if (field(table, row, "kind") == kind) all.push_back(field(table, row, "result"));
    return all;
}

TEST(Reliability, FindsNothingWrongWithWhatIsRight) { EXPECT_EQ(results(Fakes(), "good", "right"), Words(3, "ok")); }
TEST(Reliability, NoticesThatWrongSettingsAreAccepted) {
    EXPECT_EQ(results(Fakes(), "good", "wrong"), Words(3, "ended with exit 0, not with exit 2"));
}
TEST(Reliability, NoticesACrash) { EXPECT_EQ(results(Fakes(), "crashes", "right"), Words(3, "failed:signal 11")); }
TEST(Reliability, NoticesARunWithoutEnd) { EXPECT_EQ(results(Fakes(), "hangs", "right"), Words(3, "failed:timeout")); }
TEST(Reliability, NoticesASummaryOfAnotherKind) {
    EXPECT_EQ(results(Fakes(), "strange", "right"), Words(3, "summary.csv has no column verdict"));
}
TEST(Reliability, NoticesThatAFullDiskIsNotNoticed) {
    EXPECT_EQ(results(Fakes(), "crashes", "full disk"), Words{"failed:signal 11"});
    EXPECT_EQ(results(Fakes(), "fails", "full disk"), Words{"not one line on stderr"});
    EXPECT_EQ(results(Fakes(), "fails", "no folder"), Words{"not one line on stderr"});
    EXPECT_EQ(results(Fakes(), "good", "no folder"), Words{"ended with exit 0, not with exit 1"});
}
TEST(Reliability, EndsWithThreeAfterAFailure) {
    const Fakes fakes;
    EXPECT_EQ(fakes.run("reliability", {"--programs", "bin", "--runs", "1", "--only", "crashes"}).code, 3);
}

}  // namespace
}  // namespace mpm::test
