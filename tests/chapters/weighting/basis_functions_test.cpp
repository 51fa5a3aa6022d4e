/// What basis_functions writes: columns by name, every shape, weights that sum to one, and the answers to wrong input.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "chapters/weighting/shapes.hpp"

namespace mpm::test {
namespace {

class BasisFunctions : public ::testing::Test {
protected:
    const std::string folder = ::testing::TempDir() + "mpm_basis_" + std::to_string(getpid());
    void TearDown() override { std::filesystem::remove_all(folder); }

    int run(const std::string& options) const {
        const int status =
            std::system((MPM_BUILD_DIR "/basis_functions --quiet --out " + folder + " " + options + " 2>" + folder + ".err").c_str());
        std::filesystem::remove(folder + ".err");
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    /// The columns of a file by name; every row must be whole and every value a number.
    std::map<std::string, std::vector<double>> columns(const std::string& file) const {
        std::ifstream in(folder + "/" + file);
        std::string line, field;
        std::vector<std::string> names;
        std::map<std::string, std::vector<double>> result;
        std::getline(in, line);
        for (std::stringstream s(line); std::getline(s, field, ',');) names.push_back(field);
        while (std::getline(in, line)) {
            std::stringstream s(line);
            std::size_t i = 0;
            for (; std::getline(s, field, ','); ++i) result[names.at(i)].push_back(std::stod(field));
            EXPECT_EQ(i, names.size()) << file << ": " << line;
        }
        EXPECT_EQ(result.size(), names.size()) << file;
        return result;
    }
};

TEST_F(BasisFunctions, WritesEveryShapeByName) {
    ASSERT_EQ(run("--cells 3 --points 8"), 0);
    auto phi = columns("basis_1d.csv"), grad = columns("gradients_1d.csv"), square = columns("basis_2d.csv");
    EXPECT_EQ(phi.at("x").size(), 3u * 9u);
    EXPECT_EQ(square.at("x").size(), 25u * 25u);
    for (const std::string& shape : AllShapes::names()) {
        int nodes = 0;
        AllShapes::with(shape, [&](auto kernel) { nodes = 3 * kernel.per_cell + 1; });
        for (std::size_t i = 0; i < phi.at("x").size(); ++i) {
            double sum = 0, slope = 0;
            for (int I = 0; I < nodes; ++I) {
                sum += phi.at(shape + "_" + std::to_string(I))[i];
                slope += grad.at(shape + "_" + std::to_string(I))[i];
            }
            EXPECT_NEAR(sum, 1, 1e-14) << shape << " at " << phi.at("x")[i];
            EXPECT_NEAR(slope, 0, 1e-14) << shape << " at " << phi.at("x")[i];
        }
        EXPECT_EQ(phi.count(shape + "_" + std::to_string(nodes)), 0u);
        EXPECT_EQ(square.count(shape) + square.count(shape + "_dx"), 2u);
    }
    for (const char* file : {"run.ini", "checks.csv", "basis_functions.gp", "basis_2d.gp"})
        EXPECT_TRUE(std::filesystem::exists(folder + "/" + file)) << file;
}
TEST_F(BasisFunctions, DrawsAJumpUpright) {
    ASSERT_EQ(run("--cells 2 --points 4 --shape hat"), 0);
    auto grad = columns("gradients_1d.csv");
    EXPECT_EQ(grad.at("hat_1")[4], 1);
    EXPECT_EQ(grad.at("hat_1")[5], -1);
    EXPECT_NEAR(grad.at("x")[4], grad.at("x")[5], 1e-15);
}
TEST_F(BasisFunctions, IsRepeatedFromItsSettings) {
    ASSERT_EQ(run("--shape cpgimp --l 0.25 --F 3 --points 5"), 0);
    auto before = columns("basis_1d.csv");
    ASSERT_EQ(run("--config " + folder + "/run.ini"), 0);
    EXPECT_EQ(columns("basis_1d.csv"), before);
}
TEST_F(BasisFunctions, AnswersWrongInput) {
    EXPECT_EQ(run("--cells 2"), 2) << "cpgimp and cubic need three cells";
    EXPECT_EQ(run("--shape cpgimp --l 1 --F 2.5"), 2) << "a domain longer than two cells";
    EXPECT_EQ(run("--shape ugimp --l 1 --F 2.5"), 0) << "the unchanged domain does not stretch";
    EXPECT_EQ(run("--shape hut"), 2);
    EXPECT_EQ(run("--out /dev/null/folder --shape hat"), 2) << "an option given twice";
    EXPECT_EQ(run("--help"), 0);
}

}  // namespace
}  // namespace mpm::test
