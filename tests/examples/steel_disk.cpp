// steel_disk as a user runs it (review 6.1.3): the review's particles, the balance of energy, what it refuses.
#include <algorithm>
#include <cmath>

#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

const char* const program = "steel_disk";

double number(const std::vector<Words>& table, std::size_t row, const std::string& column) { return std::stod(field(table, row, column)); }
double depth(const Folder& folder, const std::string& history) {
    const auto table = csv(folder.read(history));
    return number(table, table.size() - 1, "depth");
}
Ending run(const Folder& folder, Words words) {
    words.insert(words.end(), {"--quiet", "--records", "20", "--out", "run"});
    return folder.run(program, words);
}

// 208 particles of steel, 6700 of aluminium, dt = 1e-8 s (review 6.1.3).
TEST(SteelDisk, HasTheReviewsParticlesAndStep) {
    const Folder folder;
    ASSERT_EQ(run(folder, {"--t-end", "1e-6", "--frames", "1"}).code, 0);
    const auto summary = csv(folder.read("run/summary.csv")), start = csv(folder.read("run/particles_0000.csv"));
    EXPECT_EQ(field(summary, 1, "particles"), "6908");
    EXPECT_EQ(field(summary, 1, "steps"), "100");
    EXPECT_NEAR(number(summary, 1, "dt"), 1e-8, 1e-20);
    EXPECT_EQ(field(summary, 1, "error"), "nan");  // nothing exact to compare with
    int steel = 0;
    double lowest = 1, highest = 0;
    for (std::size_t i = 1; i < start.size(); ++i) {
        const double y = number(start, i, "y");
        if (field(start, i, "material") == "0")
            ++steel, lowest = std::min(lowest, y);
        else
            highest = std::max(highest, y);
    }
    EXPECT_EQ(steel, 208);
    EXPECT_NEAR(lowest - highest, 0.6e-3, 1e-15);  // rows go on from target to disk
}

TEST(SteelDisk, BalancesEnergyAndMomentumWhileTheTargetYields) {
    for (const char* walls : {"slip", "stuck"})
        for (const char* scheme : {"musl", "usf"}) {
            const Folder folder;
            ASSERT_EQ(run(folder, {"--cells", "25", "--walls", walls, "--scheme", scheme, "--frames", "1"}).code, 0) << walls << scheme;
            const auto summary = csv(folder.read("run/summary.csv")), history = csv(folder.read("run/history.csv")),
                       end = csv(folder.read("run/particles_0001.csv"));
            EXPECT_NEAR(number(summary, 1, "energy_drift"), 0, 0.01);  // kinetic + elastic + plastic work
            EXPECT_LT(number(summary, 1, "momentum_drift"), 1e-12);    // with the impulse of the walls
            const std::size_t last = history.size() - 1;
            EXPECT_GT(number(history, last, "dissipated"), 0.75 * number(history, 1, "total"));
            EXPECT_NEAR(number(history, 1, "depth"), 0, 1e-16);  // rounding of 40 mm
            for (std::size_t i = 1; i < end.size(); ++i) {
                if (field(end, i, "material") == "0")
                    EXPECT_EQ(field(end, i, "eps_p"), "0");  // steel stays elastic
                else
                    EXPECT_LT(number(end, i, "mises"), 300e6 * (1 + 1e-9));
            }
        }
}

// On 25, 50 and 100 cells, the disk 4, 8 and 16 cells across, the change after 8 microseconds falls from 1.04 to 0.56 mm, to 0.34 on
// 200; with disks of equal mass (--rho-disk) from 1.06 to 0.64. After 40 microseconds, which takes too long here: 5.8, 1.6, 1.8, and
// with equal masses 5.4, 2.5, 1.7. On 12 cells the disk is 2 across, and no trend begins there: 2.6, 3.1, 1.25 after 20.
TEST(SteelDisk, DepthSettlesAsTheGridIsRefined) {
    const Folder folder;
    ASSERT_EQ(run(folder, {"--cells", "25,50,100", "--t-end", "8e-6"}).code, 0);
    const double coarse = depth(folder, "run/cells-25/history.csv"), middle = depth(folder, "run/cells-50/history.csv"),
                 fine = depth(folder, "run/cells-100/history.csv");
    EXPECT_GT(middle, coarse);
    EXPECT_GT(fine, middle);
    EXPECT_LT(fine - middle, 0.65 * (middle - coarse));
}

TEST(SteelDisk, HardeningAndAHigherYieldStressStopItEarlier) {
    const Folder folder;
    const auto deep = [&](const Words& words) {
        Words all{"--cells", "25", "--t-end", "20e-6"};
        all.insert(all.end(), words.begin(), words.end());
        EXPECT_EQ(run(folder, all).code, 0);
        return depth(folder, "run/history.csv");
    };
    const double ideal = deep({});
    EXPECT_LT(deep({"--hardening", "300e6"}), ideal);
    EXPECT_LT(deep({"--yield", "600e6"}), ideal);
}

// Thrown-out particles leave nodes of tiny mass: USL divides by it (review figure 10), and its run must say so; a cut-off mends it.
TEST(SteelDisk, UslNeedsItsCutOff) {
    const Folder folder;
    EXPECT_EQ(run(folder, {"--scheme", "usl", "--t-end", "3e-6"}).code, 3);
    EXPECT_EQ(field(csv(folder.read("run/summary.csv")), 1, "verdict"), "unstable:energy-growth");
    EXPECT_EQ(run(folder, {"--scheme", "usl", "--cutoff", "1e-6", "--t-end", "3e-6"}).code, 0);
}

TEST(SteelDisk, RefusesWhatMeansNothing) {
    for (const auto& [words, parts] : std::vector<std::pair<Words, Words>>{
             {{"--cutoff", "1e-6"}, {"--cutoff", "usl", "musl"}},
             {{"--transfer", "apic", "--alpha", "0.5"}, {"--alpha", "apic"}},
             {{"--diameter", "0.07"}, {"--diameter", "0.07", "--width 0.06"}},
             {{"--cells", "3", "--ppc", "1", "--diameter", "1e-3"}, {"--diameter", "no particle"}},
             {{"--height", "1e9"}, {"--height", "cells"}},
             {{"--yield", "0"}, {"--yield", "> 0"}},
             {{"--nu-target", "0.5"}, {"--nu-target", "0.5"}},
             {{"--shape", "bernstein"}, {"--shape", "hat"}},
             {{"--walls", "free"}, {"--walls", "slip"}}}) {
        const Folder folder;
        expect_one_line(folder.run(program, words), 2, parts);
        EXPECT_TRUE(folder.empty());
    }
}

}  // namespace
}  // namespace mpm::test
