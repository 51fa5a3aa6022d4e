// The programs of contact as a user runs them, against NUMBERS section 14 and exact solutions.
#include <cmath>

#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

struct Outcome {
    std::vector<Words> summary;
    std::string out;
    double error(const std::string& name) const {
        for (std::size_t row = 1; row < summary.size(); ++row)
            if (field(summary, row, "error_name") == name) return std::stod(field(summary, row, "error"));
        return std::nan("");
    }
    double number(const std::string& column) const { return std::stod(field(summary, 1, column)); }
};
Outcome run(const std::string& program, Words words) {
    const Folder folder;
    words.insert(words.end(), {"--out", "run"});
    Outcome r;
    const Ending ending = folder.run(program, words);
    EXPECT_EQ(ending.code, 0) << ending.err << ending.out;
    r.out = ending.out;
    r.summary = csv(folder.read("run/summary.csv"));
    return r;
}
const Words as_printed{"--normals", "gradient", "--common", "off", "--gap", "velocity"};
const Words sudden{"--scheme", "usf", "--rise", "0", "--t-end", "1", "--ppc", "2"};
Words joined(Words a, const Words& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// NUMBERS section 14, first and third row: the travel that is lost. The reference is another code: 2 % of the exact travel.
TEST(Slope, AsPrintedLosesTheTravelOfTheReference) {
    const Words words = joined(sudden, as_printed);
    const Words disk = joined(words, {"--placing", "cells"});
    EXPECT_NEAR(run("rolling_disk", joined(disk, {"--mu", "0"})).error("travel"), 0.417, 0.02);
    EXPECT_NEAR(run("rolling_disk", joined(disk, {"--mu", "0.1"})).error("travel"), 0.362, 0.02);
    EXPECT_NEAR(run("rolling_disk", joined(disk, {"--mu", "0.3"})).error("travel"), 0.267, 0.02);
    EXPECT_NEAR(run("sliding_block", words).error("travel"), 0.885, 0.02);
    EXPECT_NEAR(run("sliding_block", joined(words, {"--grid", "inclined"})).error("travel"), 0.889, 0.02);
}
TEST(Slope, WithCommonNormalsAndPositionsAsTheReference) {
    const Words words = joined(sudden, {"--normals", "volume"}), position = joined(words, {"--gap", "position"});
    EXPECT_NEAR(run("rolling_disk", joined(position, {"--placing", "cells"})).error("travel"), 0.026, 0.01);
    EXPECT_NEAR(run("sliding_block", position).error("travel"), 0.072, 0.02);
    EXPECT_NEAR(run("sliding_block", joined(words, {"--gap", "velocity"})).error("travel"), 0.237, 0.03);
}
// The default. 2 % is required at h = 0.05; the block reaches 1 % at h = 0.1, the disk at h = 0.05.
TEST(Slope, WithTheDefaultTravelsAsARigidBody) {
    for (const char* grid : {"aligned", "inclined"})
        for (const char* mu : {"0", "0.3"}) EXPECT_LT(run("sliding_block", {"--grid", grid, "--mu", mu}).error("travel"), 0.01) << grid << mu;
    EXPECT_LT(run("rolling_disk", {"--mu", "0.1"}).error("travel"), 0.01);
    EXPECT_LT(run("rolling_disk", {"--cells", "20", "--t-end", "0.6"}).error("travel"), 0.02);
}
// Steeper than friction holds: tan 30 = 0.577 < 0.7.
TEST(Slope, HoldsABlockByFriction) {
    for (const char* grid : {"aligned", "inclined"})
        EXPECT_LT(run("sliding_block", {"--mu", "0.7", "--rise", "0.3", "--t-end", "1", "--grid", grid}).error("creep"), 1e-3) << grid;
}
// Friction and the normal impulses, summed on their own, close the balance of energy.
TEST(Slope, ClosesItsBalanceOfEnergy) {
    EXPECT_LT(std::abs(run("sliding_block", {}).number("energy_drift")), 5e-3);
    EXPECT_LT(run("sliding_block", {"--t-end", "0.3"}).number("momentum_drift"), 1e-12);
}
TEST(HeadOnBars, TouchFor2LOverC) {
    const Outcome r = run("head_on_bars", {"--cells", "200"});
    EXPECT_LT(r.error("duration"), 0.02);
    EXPECT_LT(r.error("velocity"), 0.02);
    EXPECT_LT(r.error("touch"), 0.005);
    EXPECT_LT(r.error("energy"), 0.005);
    EXPECT_LT(r.number("momentum_drift"), 1e-12);
}
// The light bar rebounds from one a million times as dense as from a wall that comes towards it: 3 v0.
TEST(HeadOnBars, ALightOneReboundsFromAHeavyOne) {
    const Outcome r = run("head_on_bars", {"--cells", "100", "--density-ratio", "1e6"});
    EXPECT_LT(r.error("velocity"), 0.05);  // a cell, a hundredth of the length, for each of the four passages of the wave
}
TEST(TwoDisksContact, TouchWithinAFifthOfACell) {
    EXPECT_LT(run("two_disks_contact", {"--t-end", "1.8"}).error("touch"), 0.2 * 0.05);
    EXPECT_GT(run("two_disks_contact", {"--t-end", "1.8", "--field", "shared"}).error("touch"), 0.05);  // a cell and more
}
TEST(DiskOnWall, ReboundsWithinTheEstimate) {
    const Outcome r = run("disk_on_wall", {});
    EXPECT_LT(r.error("rebound"), 0.05);
    EXPECT_LT(r.error("duration"), 0.10);  // the estimate knows no waves, which need half of its time to cross
    EXPECT_LT(r.number("momentum_drift"), 1e-12);
}
TEST(Contact, RefusesWhatCannotBe) {
    const Folder folder;
    expect_one_line(folder.run("sliding_block", {"--mu", "-1"}), 2, {"--mu", "-1"});
    expect_one_line(folder.run("sliding_block", {"--normals", "surface"}), 2, {"--normals", "regression"});
    expect_one_line(folder.run("disk_on_wall", {"--wall-speed", "-2"}), 2, {"--wall-speed"});
    expect_one_line(folder.run("sliding_block", {"--placing", "rings"}), 2, {"--placing"});
}

}  // namespace
}  // namespace mpm::test
