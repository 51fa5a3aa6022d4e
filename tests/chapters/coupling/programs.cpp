// Programs of MPM with finite elements, as a user would run them.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

double number(const std::vector<Words>& table, std::size_t row, const std::string& column) { return std::stod(field(table, row, column)); }
std::vector<Words> summary(const std::string& program, Words words) {
    const Folder folder;
    words.insert(words.end(), {"--quiet", "--out", "run"});
    const Ending end = folder.run(program, words);
    EXPECT_EQ(end.code, 0) << program << ": " << end.err;
    return csv(folder.read("run/summary.csv"));
}

TEST(CoupledBar, BehavesAsOneBar) {
    const double coupled = number(summary("coupled_bar", {}), 1, "error");
    const double fem = number(summary("coupled_bar", {"--bodies", "fem"}), 1, "error");
    const double mpm = number(summary("coupled_bar", {"--bodies", "mpm"}), 1, "error");
    EXPECT_LT(coupled, 1.05 * std::max(fem, mpm));
    EXPECT_LT(coupled, 5e-3);  // dispersion of 24 cells in the half pulse
}
TEST(CoupledBar, ReflectsAndTransmitsByTheImpedances) {
    for (const char* from : {"fem", "mpm"})
        for (const char* contrast : {"0.1", "4"}) {
            const auto rows = summary("coupled_bar", {"--contrast", contrast, "--from", from});
            EXPECT_LT(number(rows, 2, "error"), 0.01) << from << ' ' << contrast;  // transmitted
            EXPECT_LT(number(rows, 3, "error"), 0.01) << from << ' ' << contrast;  // reflected
        }
}
// The pulse would be past the end of the bar, where the exact wave is nothing.
TEST(CoupledBar, SaysWhenNoWaveIsExact) {
    const auto rows = summary("coupled_bar", {"--cells", "20", "--t-end", "0.6"});
    EXPECT_EQ(field(rows, 1, "reference"), "none");
    EXPECT_EQ(field(rows, 1, "error"), "nan");
    EXPECT_EQ(field(summary("coupled_bar", {"--cells", "20"}), 1, "reference"), "exact");
}
TEST(CoupledRollingDisk, RollsOverThePlate) {
    const Folder folder;
    const Ending end = folder.run("coupled_rolling_disk",
                                  {"--E", "4.2e7", "--around", "60", "--layers", "5", "--t-end", "0.3", "--out", "run"});
    EXPECT_EQ(end.code, 0) << end.err;
    const auto rows = csv(folder.read("run/summary.csv"));
    EXPECT_LT(number(rows, 1, "error"), 0.25);  // coarse and short; (52) falls with time
    EXPECT_LT(number(rows, 1, "momentum_drift"), 1e-8);
    EXPECT_NE(end.out.find("particles found inside the body                 0\n"), std::string::npos);
}
// The drop is more than the height of the elements over the plate, within which the disk feels it. Lost height, on coarse cells.
TEST(BouncingDisk, BothWaysBounce) {
    const Words drop{"--cells", "32", "--drop", "0.1", "--t-end", "0.32"};
    Words coupled{"--around", "80", "--layers", "6", "--receding", "0", "--near", "0.001"}, contact;
    for (Words* words : {&coupled, &contact}) words->insert(words->end(), drop.begin(), drop.end());
    EXPECT_LT(std::abs(number(summary("bouncing_disk", coupled), 1, "error")), 0.2);
    EXPECT_LT(std::abs(number(summary("bouncing_disk_contact", contact), 1, "error")), 0.2);
}
TEST(CoupledPrograms, RefuseWhatCannotBe) {
    const Folder folder;
    for (const Words& words : {Words{"coupled_bar", "--cells", "51"}, Words{"coupled_bar", "--carry", "lumped"},
                               Words{"coupled_rolling_disk", "--ppc", "2"}, Words{"bouncing_disk", "--dt", "0.1"},
                               Words{"bouncing_disk", "--cells", "20"}, Words{"bouncing_disk_contact", "--cells", "20"}}) {
        const Ending end = folder.run(words[0], {words.begin() + 1, words.end()});
        EXPECT_EQ(end.code, 2) << words[0];
        EXPECT_EQ(end.err.find('\n'), end.err.size() - 1) << end.err;
    }
}

}  // namespace
}  // namespace mpm::test
