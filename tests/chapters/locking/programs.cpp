// fbar_cantilever and fbar_block as a user runs them, against NUMBERS section 17.
#include <algorithm>
#include <cmath>

#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

struct Ran {
    double peak, within, between, drift;
};
Ran ran(const std::string& program, Words words, const std::string& verdict = "ok") {
    const Folder folder;
    words.insert(words.end(), {"--watch", "warn", "--quiet", "--out", "run"});
    EXPECT_EQ(folder.run(program, words).code, verdict == "ok" ? 0 : 3);
    const auto summary = csv(folder.read("run/summary.csv"));
    EXPECT_EQ(field(summary, 1, "verdict"), verdict);
    const auto error = [&](std::size_t row) { return std::stod(field(summary, row, "error")); };
    return {1 - error(1), error(2), error(3), std::stod(field(summary, 1, "energy_drift"))};  // every peak here is below the beam's
}

// First peak over twice Timoshenko's deflection at nu = .499: .18, .21 locked. Particles' tips are carried on to the end here, which adds 2
// %.
TEST(FbarCantilever, HatsLockAndFbarCures) {
    EXPECT_NEAR(ran("fbar_cantilever", {"--fbar", "off"}, "unstable:locking").peak, 0.18, 0.02);
    EXPECT_NEAR(ran("fbar_cantilever", {"--fbar", "off", "--shape", "ugimp"}, "unstable:locking").peak, 0.21, 0.02);
    EXPECT_GT(ran("fbar_cantilever", {}).peak, 0.94);
    EXPECT_GT(ran("fbar_cantilever", {"--shape", "ugimp"}).peak, 0.92);
}

// Grid cells throw their pressure from cell to cell as particles cross; the total-Lagrangian form and moving cells do not.
TEST(FbarCantilever, TotalLagrangianAndMovingCellsAreCalm) {
    const Ran grid = ran("fbar_cantilever", {"--fbar", "grid", "--shape", "ugimp"}), moving = ran("fbar_cantilever", {"--shape", "ugimp"});
    const Ran total = ran("fbar_cantilever", {"--scheme", "tlmpm"});
    EXPECT_GT(total.peak, 0.94);
    for (const Ran& r : {grid, moving, total}) EXPECT_LT(r.within, 1e-6);
    EXPECT_LT(5 * total.between, grid.between);
    EXPECT_LT(5 * moving.between, grid.between);
    EXPECT_LT(std::abs(moving.drift), 1e-3);
}

// No exact solution: the panel with F-bar is twice as compliant, and gives every cell one pressure.
TEST(FbarBlock, HatsLockAndFbarCures) {
    const auto largest = [](const std::string& fbar) {
        const Folder folder;
        const Words words{"--scheme", "tlmpm", "--cells", "8", "--fbar", fbar, "--watch", "warn", "--quiet", "--out", "run"};
        EXPECT_EQ(folder.run("fbar_block", words).code, fbar == "off" ? 3 : 0) << "one locks, and says so";
        const auto history = csv(folder.read("run/history.csv"));
        double tip = 0;
        for (std::size_t row = 1; row < history.size(); ++row) tip = std::max(tip, std::stod(field(history, row, "tip")));
        return tip;
    };
    EXPECT_GT(largest("moving"), 2 * largest("off"));
    const Words coarse{"--scheme", "tlmpm", "--cells", "8", "--nu", "0.499"};
    EXPECT_LT(ran("fbar_block", coarse).within, 1e-6);
}

TEST(FbarPrograms, RefuseWhatTheyHaveNot) {
    const Folder folder;
    expect_one_line(folder.run("fbar_cantilever", {"--scheme", "usl", "--shape", "cubic"}), 2, {"--shape cubic", "usl"});
    expect_one_line(folder.run("fbar_block", {"--nu", "0.5"}), 2, {"--nu", "0.5"});
}

}  // namespace
}  // namespace mpm::test
