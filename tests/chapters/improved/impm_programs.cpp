// The programs of the improved MPM as a user runs them.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "lab/csv_read.hpp"

namespace mpm::test {
namespace {

class ImpmPrograms : public ::testing::Test {
protected:
    const std::string folder = ::testing::TempDir() + "mpm_impm_" + std::to_string(getpid());
    void TearDown() override { std::filesystem::remove_all(folder); }
    int run(const std::string& words) const {
        const int status = std::system((MPM_BUILD_DIR "/" + words + " --quiet --out " + folder + " 2>/dev/null").c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    /// The value of an error in the row of a resolution.
    double error(const std::string& name, double cells) const {
        const CsvTable table = read_csv(folder + "/summary.csv");
        for (std::size_t row = 0; row < table.rows.size(); ++row)
            if (table.text(row, "error_name") == name && table.number(row, "cells") == cells) return table.number(row, "error");
        return std::nan("");
    }
};

// Mode 1 through its first two periods; NUMBERS 2: 2.5e-3 for the hat function's MUSL on 13 cells, order two.
TEST_F(ImpmPrograms, TheBarsFrequencyConvergesWithOrderTwo) {
    ASSERT_EQ(run("impm_bar --periods 2 --cells 16,32"), 0);
    EXPECT_LT(error("frequency", 16), 2e-3);
    EXPECT_NEAR(std::log2(error("frequency", 16) / error("frequency", 32)), 2, 0.1);
}
// Timoshenko's beam itself leaves out the clamp's hindrance of lateral strain: a few tenths of a percent.
TEST_F(ImpmPrograms, TheCantileverFollowsBeamTheory) {
    ASSERT_EQ(run("impm_cantilever --cells 16 --periods 1"), 0);
    EXPECT_LT(error("frequency", 16), 0.005);
    EXPECT_LT(error("tip_L2", 16), 0.02);
}
TEST_F(ImpmPrograms, OnePointPerCellDoesNotHoldTheCantilever) {
    EXPECT_EQ(run("impm_cantilever --cells 16 --periods 1 --quadrature centre"), 3);
}
TEST_F(ImpmPrograms, TellTheGrowthOfNoise) {
    ASSERT_EQ(run("impm_noise --support 1.01 --cells 32,128"), 0);
    const CsvTable noise = read_csv(folder + "/noise.csv"), theory = read_csv(folder + "/theory.csv");
    EXPECT_EQ(noise.number(0, "hat"), 1);
    EXPECT_GT(noise.number(1, "hat"), 1.5);
    EXPECT_EQ(noise.number(1, "linear"), 1);
    EXPECT_NEAR(theory.number(20, "rate_hat"), 0.0518, 0.0002);
    EXPECT_NEAR(theory.number(20, "rate_linear"), 0, 2e-5);
}
TEST_F(ImpmPrograms, RefuseWhatTheyCannotDo) {
    EXPECT_EQ(run("impm_bar --shape cubic"), 2);
    EXPECT_EQ(run("impm_bar --quadrature gauss"), 2);
    EXPECT_EQ(run("impm_bar --limit 0.5"), 2);
    EXPECT_EQ(run("impm_cantilever --height 3"), 2);
    EXPECT_EQ(run("impm_cantilever --cells 8"), 2) << "a single cell across";
    EXPECT_EQ(run("impm_noise --G 0.4"), 2);
    EXPECT_FALSE(std::filesystem::exists(folder));
}

}  // namespace
}  // namespace mpm::test
