// Two bodies meet: what a particle feels as it crosses cells, and what cell_crossing writes and answers.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/usl.hpp"
#include "chapters/scenes/two_bodies.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "lab/csv_read.hpp"

namespace mpm::test {
namespace {

struct Flight {
    double momentum = 0;  // largest ever, over the sum of m |v| at the start
    std::map<std::string, double> errors;
};

Flight fly(const std::string& shape, int ppc, double offset, double cfl) {
    TwoBodies scene;
    scene.offset = offset;
    Common common;
    common.ppc = ppc;
    Flight flight;
    UpdatedShapes::with(shape, [&](auto kernel) {
        Assembled a = assemble_with<decltype(kernel), false>(Usl{}, scene, Flip{}, scene.cells, common);
        const int steps = static_cast<int>(std::ceil(scene.t_end / (cfl * a.critical_dt)));
        const double dt = scene.t_end / steps, in_play = a.simulation.measure().momentum_in_play;
        a.simulation.sample(0, 0);
        for (int k = 0; k < steps; ++k) {
            a.simulation.step(k * dt, dt);
            a.simulation.sample((k + 1) * dt, 0);
            flight.momentum = std::max(flight.momentum, std::abs(a.simulation.measure().momentum[0]) / in_play);
        }
        for (const NamedError& e : a.errors(scene.t_end)) flight.errors[e.name] = e.value;
    });
    return flight;
}
const std::vector<std::string> smooth{"ugimp", "cpgimp", "quadratic", "cubic"};

// Measured: 1.2 to 1.9 with one particle per body (the hat gradient of the node in between jumps from 0 to 1/h: 1 at least), 5.9 with
// three; smooth functions .0015 to .0054 and .0017 to .022.
TEST(CellCrossing, StrainRateJumpsWithHatOnly) {
    for (const auto& [ppc, offset, least, most] : {std::tuple{1, 0.0, 0.99, 0.01}, std::tuple{3, 0.05, 3.0, 0.04}}) {
        const Flight hat = fly("hat", ppc, offset, 0.015);
        EXPECT_GT(hat.errors.at("rate_jump"), least) << ppc;
        for (const std::string& shape : smooth) {
            const double jump = fly(shape, ppc, offset, 0.015).errors.at("rate_jump");
            EXPECT_LT(jump, most) << shape << ", " << ppc;
            EXPECT_GT(hat.errors.at("rate_jump") / jump, 100) << shape << ", " << ppc;
        }
    }
}

// A jump that is one stays, however small the step; what changes smoothly changes by O(dt) in a step. Measured: hat .74 and .80, smooth
// halved.
TEST(CellCrossing, SmallerStepsMendTheForcesOfSmoothFunctionsOnly) {
    EXPECT_GT(fly("hat", 3, 0.05, 0.015).errors.at("force_jump"), 0.5);
    EXPECT_GT(fly("hat", 3, 0.05, 0.0075).errors.at("force_jump"), 0.5);
    for (const std::string& shape : smooth) {
        const double coarse = fly(shape, 3, 0.05, 0.015).errors.at("force_jump"),
                     fine = fly(shape, 3, 0.05, 0.0075).errors.at("force_jump");
        EXPECT_LT(coarse, 0.01) << shape;
        EXPECT_NEAR(coarse / fine, 2, 0.1) << shape;
    }
}

// Three particles of hat functions, a twentieth of a cell off the middle: crossing under stress spoils it, and .12 of the energy stays in
// the bodies.
TEST(CellCrossing, HatLeavesStrainEnergyBehind) {
    const Flight hat = fly("hat", 3, 0.05, 0.015);
    EXPECT_GT(hat.errors.at("strain_left"), 0.08);
    for (const char* gimp : {"ugimp", "cpgimp"}) EXPECT_LT(fly(gimp, 3, 0.05, 0.015).errors.at("strain_left"), 0.03) << gimp;
}

// USL loses energy in a rebound in proportion to the time step, most of all with wide functions: measured .21, .10, .05.
TEST(CellCrossing, ReboundBecomesElasticWithTheTimeStep) {
    const double coarse = fly("quadratic", 1, 0, 0.03).errors.at("rebound"), fine = fly("quadratic", 1, 0, 0.0075).errors.at("rebound");
    EXPECT_NEAR(coarse / fine, 4, 0.5);
    EXPECT_LT(fine, 0.06);
}

TEST(CellCrossing, MomentumIsKept) {
    for (const std::string& shape : UpdatedShapes::names()) EXPECT_LT(fly(shape, 3, 0.05, 0.015).momentum, 1e-13) << shape;
}

TEST(CrossingMeter, SeesJumpsOfRateAndAcceleration) {
    std::vector<Point<1>> points(1);
    CrossingMeter meter;
    const auto see = [&](double t, double x, double v, double F) {
        points[0].x[0] = x, points[0].v[0] = v, points[0].F(0, 0) = F;
        meter.see(points, 0, t, 1.0);
    };
    see(0, 0.9, 1, 1);
    see(0.5, 1.4, 1, 1.1);
    EXPECT_NEAR(meter.rate, 0.2, 1e-14);
    EXPECT_NEAR(meter.rate_jump, 0.2, 1e-14);
    EXPECT_EQ(meter.force_jump, 0);
    see(1, 1.6, 0, 1.1);
    EXPECT_EQ(meter.rate, 0);
    EXPECT_NEAR(meter.rate_jump, 0.2, 1e-14);
    EXPECT_NEAR(meter.force_jump, 2, 1e-14);
    EXPECT_EQ(meter.crossings, 1);
}

class CellCrossingProgram : public ::testing::Test {
protected:
    const std::string folder = ::testing::TempDir() + "mpm_crossing_" + std::to_string(getpid());
    void TearDown() override { std::filesystem::remove_all(folder); }
    int run(const std::string& options) const {
        const int status =
            std::system((MPM_BUILD_DIR "/cell_crossing --quiet --out " + folder + " " + options + " 2>" + folder + ".err").c_str());
        std::filesystem::remove(folder + ".err");
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
};

TEST_F(CellCrossingProgram, WritesEveryShapeSideBySide) {
    ASSERT_EQ(run("--records 50"), 0);
    const CsvTable together = read_csv(folder + "/cell_crossing.csv"), summary = read_csv(folder + "/summary.csv");
    EXPECT_EQ(together.rows.size(), 51u);
    for (const std::string& shape : UpdatedShapes::names()) {
        EXPECT_NEAR(together.number(0, "x_" + shape), 0.5 / 6, 1e-15) << shape;
        EXPECT_LT(together.number(50, "v_" + shape), 0) << shape << " has rebounded";
        EXPECT_EQ(read_csv(folder + "/" + shape + "/history.csv").rows.size(), 51u);
    }
    ASSERT_EQ(summary.rows.size(), 4 * UpdatedShapes::names().size());
    EXPECT_EQ(summary.text(0, "shape"), "hat");
    EXPECT_EQ(summary.text(0, "error_name"), "rate_jump");
    EXPECT_EQ(summary.text(0, "verdict"), "ok");
    for (const char* file : {"run.ini", "cell_crossing.gp"}) EXPECT_TRUE(std::filesystem::exists(folder + "/" + file)) << file;
}
TEST_F(CellCrossingProgram, RunsOneShapeAndIsRepeatedFromItsSettings) {
    ASSERT_EQ(run("--shape cubic --ppc 2 --t-end 2 --records 10"), 0);
    const std::string before = read_file(folder + "/history.csv");
    ASSERT_EQ(run("--config " + folder + "/run.ini"), 0);
    EXPECT_EQ(read_file(folder + "/history.csv"), before);
}
TEST_F(CellCrossingProgram, SaysWhenARunBecomesUnstable) {
    ASSERT_EQ(run("--cfl 3"), 3);
    const CsvTable summary = read_csv(folder + "/summary.csv");
    EXPECT_TRUE(summary.text(0, "verdict").starts_with("unstable:")) << summary.text(0, "verdict");
    EXPECT_TRUE(std::isnan(summary.number(0, "error")));
    EXPECT_FALSE(summary.text(0, "reason").empty());
    EXPECT_EQ(summary.rows.size(), 4 * UpdatedShapes::names().size()) << "the others go on";
}
TEST_F(CellCrossingProgram, AnswersWrongInput) {
    EXPECT_EQ(run("--cells 3"), 2);
    EXPECT_EQ(run("--shape bernstein"), 2) << "only for total-Lagrangian schemes";
    EXPECT_EQ(run("--dt 0.01 --cfl 0.1"), 2);
    EXPECT_EQ(run("--v0 1e9"), 2) << "a grid that cannot be";
    EXPECT_FALSE(std::filesystem::exists(folder));
    EXPECT_EQ(run("--help"), 0);
}

}  // namespace
}  // namespace mpm::test
