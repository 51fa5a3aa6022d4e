// Bad input: exit code 2, one line that names the option, nothing run, nothing written.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "lab/record.hpp"
#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

/// A folder with an earlier run in `old`, which no refused run may touch.
class Refusal : public testing::TestWithParam<std::string> {
protected:
    Refusal() {
        EXPECT_EQ(folder.run(GetParam(), {"--cells", "5", "--t-end", "1", "--quiet", "--out", "old"}).code, 0);
        before = folder.listing();
    }
    ~Refusal() override { EXPECT_EQ(folder.listing(), before) << "a refused run has written something"; }

    /// `words` are refused in one line that holds `parts`, in the old folder and in the default one.
    void expect_refused(Words words, const Words& parts) {
        SCOPED_TRACE(GetParam() + " " + testing::PrintToString(words));
        expect_one_line(folder.run(GetParam(), words), 2, parts);
        words.insert(words.begin(), {"--out", "old"});
        expect_one_line(folder.run(GetParam(), words), 2, parts);
    }
    std::vector<Words> described() { return csv(folder.run(GetParam(), {"--describe"}).out); }

    Folder folder;
    std::map<std::string, std::pair<std::filesystem::file_time_type, std::string>> before;
};
INSTANTIATE_TEST_SUITE_P(Programs, Refusal, testing::ValuesIn(programs()), program_name);

/// A number just outside a bound, as a user would write it.
std::string beyond(const std::string& bound, double by) { return number_text(std::strtod(bound.c_str(), nullptr) + by); }
std::string whole(const std::string& bound, long by) { return std::to_string(std::lround(std::strtod(bound.c_str(), nullptr)) + by); }

/// Values that an option must not take, from its row of --describe.
Words wrong_values(const std::vector<Words>& table, std::size_t row) {
    const auto get = [&](const char* column) { return field(table, row, column); };
    const std::string type = get("type"), low = get("low"), high = get("high");
    if (type == "text") return {"a\nb", "\x7f"};
    if (type == "choice") return {"", "nonsense", "nan", "1", get("default") + "x", std::string(" ").append(get("default"))};
    Words wrong{"", "x", "1x", "nan", "inf", "-inf", "1e999", "1,,2", ",", "--"};
    const auto add = [&](const Words& more) { wrong.insert(wrong.end(), more.begin(), more.end()); };
    if (type == "number") {
        if (!low.empty()) wrong.push_back(beyond(low, -1e-3));
        if (!high.empty()) wrong.push_back(beyond(high, 1e-3));
        return wrong;
    }
    add({"2.5", "1e1", "99999999999", whole(low, -1), whole(high, 1)});
    if (type == "integers") add({whole(low, 0).append(",").append(whole(low, -1)), "10,", "10;20"});
    return wrong;
}

TEST_P(Refusal, OfEveryWrongValueOfEveryOption) {
    const auto table = described();
    ASSERT_GT(table.size(), 15u);
    for (std::size_t row = 1; row < table.size(); ++row) {
        const std::string name = "--" + field(table, row, "name");
        if (field(table, row, "type") == "flag") {
            expect_one_line(folder.run(GetParam(), {name + "=true"}), 2, {name});
            continue;
        }
        for (const std::string& value : wrong_values(table, row)) {
            SCOPED_TRACE(GetParam() + " " + name + "=" + value);
            expect_one_line(folder.run(GetParam(), {name + "=" + value}), 2, {name + " = "});
        }
        expect_one_line(folder.run(GetParam(), {name}), 2, {name + " needs a value"});
    }
}

TEST_P(Refusal, OfZeroWhereANumberMustBePositive) {
    for (const char* name : {"--E", "--rho", "--length", "--v0", "--cfl", "--t-end"})
        expect_refused({name, "0"}, {std::string(name) + " = 0", "> 0"});
}
TEST_P(Refusal, OfUnknownOptions) { expect_refused({"--mdoe", "3"}, {"--mdoe", "--mode"}); }
TEST_P(Refusal, OfUnknownShapes) { expect_refused({"--shape", "hut"}, {"--shape", "hut", "ugimp"}); }
TEST_P(Refusal, OfTimeStepGivenTwoWays) { expect_refused({"--dt", "0.01", "--cfl", "0.5"}, {"--dt", "--cfl"}); }
TEST_P(Refusal, OfAFixedTimeStepThatChanges) { expect_refused({"--dt", "0.01", "--dt-from", "step"}, {"--dt", "--dt-from"}); }
TEST_P(Refusal, OfTransferSettingsWithoutMeaning) {
    expect_refused({"--transfer", "xpic", "--alpha", "0.5"}, {"--alpha", "xpic"});
    expect_refused({"--transfer", "flip", "--order", "3"}, {"--order", "flip"});
    expect_refused({"--transfer", "consistent", "--ppc", "1"}, {"--transfer", "--ppc"});
}
TEST_P(Refusal, OfEndGivenTwoWays) { expect_refused({"--t-end", "1", "--periods", "1"}, {"--t-end", "--periods"}); }
TEST_P(Refusal, OfLabelsThatAreNoFolderName) {
    for (const char* label : {"a/b", "..", "."}) {
        SCOPED_TRACE(label);
        expect_one_line(folder.run(GetParam(), {"--label", label, "--t-end", "1"}), 2, {"--label"});
    }
}
TEST_P(Refusal, OfMoreStepsThanAnyoneWaitsFor) {
    expect_refused({"--t-end", "1e300"}, {"--t-end"});
    expect_refused({"--dt", "1e-300"}, {"--dt"});
}
TEST_P(Refusal, OfAGridThatFitsNoMemory) {
    // A bar hit that hard swings far beyond its end; a total-Lagrangian one keeps its grid and is refused for its step.
    for (const char* v0 : {"1e12", "1e300"}) expect_refused({"--v0", v0}, {"--"});
}
TEST_P(Refusal, OfBadLinesInConfigFiles) {
    Folder other;
    const std::string path = other.path("case.ini");
    ASSERT_EQ(other.run(GetParam(), {"--cells", "5", "--t-end", "1", "--quiet", "--out", "."}).code, 0);
    std::filesystem::rename(other.path("run.ini"), path);
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 6);  // the last line, a flag, loses its value
    expect_refused({"--config", path}, {"case.ini:"});
}

// The review keeps Bernstein functions to total-Lagrangian schemes.
TEST(Shapes, BernsteinIsRefusedByUpdatedLagrangianPrograms) {
    const Folder folder;
    for (const char* program : {"usl_bar", "usf_bar", "musl_bar"})
        expect_one_line(folder.run(program, {"--shape", "bernstein"}), 2, {"--shape"});
    EXPECT_TRUE(folder.empty());
    EXPECT_EQ(folder.run("tlmpm_bar", {"--shape", "bernstein", "--t-end", "1", "--cells", "5"}).code, 0);
}

}  // namespace
}  // namespace mpm::test
