// The run loop on made-up simulations: whole steps, records, and a name for every way to go wrong.
#include "lab/run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>

namespace mpm {
namespace {

struct Run : testing::Test {
    Simulation sim;
    RunPlan plan;
    double energy = 1, critical = 1;
    std::vector<double> times;
    int kept = 0, restored = 0;

    Run() {
        plan.folder = testing::TempDir() + "mpm_run_" + testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::create_directories(plan.folder);
        plan.dt = 0.1, plan.t_end = 1, plan.steps = 10, plan.records = 5, plan.critical_dt = 1;
        sim.step = [this](double t, double dt) { times.push_back(t + dt); };
        sim.measure = [this] {
            Measures m;
            m.kinetic = energy;
            return m;
        };
        sim.check = [] { return Trouble{}; };
        sim.inspect = [] { return Trouble{}; };
        sim.where = [] { return std::string("particle 7"); };
        sim.critical_dt = [this] { return critical; };
        sim.sample = [](double, double) {};
        sim.wants_energy = [](double) { return false; };
        sim.watch = [](double) { return std::vector<double>{}; };
        sim.particles = [] { return Snapshot{{"x"}, {0.5, 1.5}}; };
        sim.nodes = [] { return GridSnapshot{{{"body", "x", "m", "mv"}, {0, 0, 1, 2, 0, 1, 0, 0}}, {2, 1}, {}, {1, 1}}; };
        sim.keep = [this] { ++kept; };
        sim.restore = [this] { ++restored; };
    }
    int rows() const {
        std::ifstream file(plan.folder + "/history.csv");
        int n = 0;
        for (std::string line; std::getline(file, line);) ++n;
        return n - 1;
    }
};

TEST_F(Run, TakesWholeStepsToItsEnd) {
    const RunResult r = run(sim, plan);
    EXPECT_TRUE(r.ok());
    EXPECT_EQ(r.steps, 10);
    EXPECT_EQ(r.t, 1);
    EXPECT_EQ(rows(), 6);  // the start and five records
}

TEST_F(Run, StepsAfreshEndExactlyAtTheEnd) {
    plan.cfl = 0.3;
    critical = 0.5;
    sim.step = [this](double t, double dt) { times.push_back(t + dt), critical *= 0.9; };
    const RunResult r = run(sim, plan);
    EXPECT_TRUE(r.ok());
    EXPECT_EQ(r.t, 1);
    EXPECT_NEAR(times[0], 0.15, 1e-15);
    EXPECT_NEAR(times[1], 0.15 + 0.135, 1e-15);
}

TEST_F(Run, WritesSnapshotsInTheFormatsThatAreAskedFor) {
    plan.frames = 2;
    plan.particles = {true, true};
    plan.nodes = {false, true};
    const RunResult r = run(sim, plan);
    const auto has = [&](const char* name) { return std::filesystem::exists(plan.folder + "/" + name); };
    for (const char* name : {"particles_0000.csv", "particles_0001.vtk", "particles_0002.csv", "nodes_0000.vtk", "nodes_0002.vtk"})
        EXPECT_TRUE(has(name)) << name;
    EXPECT_FALSE(has("nodes_0000.csv"));
    for (const char* name : {"particles.vtk.series", "nodes.vtk.series"}) {
        EXPECT_TRUE(has(name));
        EXPECT_NE(std::find(r.files.begin(), r.files.end(), plan.folder + "/" + name), r.files.end());
    }
}

TEST_F(Run, AVanishingStepIsNamed) {
    plan.cfl = 0.3;
    critical = 0.5;
    sim.step = [this](double, double) { critical *= 1e-3; };
    const RunResult r = run(sim, plan);
    EXPECT_EQ(r.trouble.cause, "time-step-floor");
    EXPECT_TRUE(r.stopped);
    EXPECT_EQ(restored, 1);
}

TEST_F(Run, GrowingEnergyIsNamedWithTimePlaceAndNumber) {
    sim.step = [this](double, double) { energy *= 1.2; };
    const RunResult r = run(sim, plan);
    EXPECT_EQ(r.trouble.cause, "energy-growth");
    EXPECT_NEAR(r.t_fail, 0.2, 1e-12);  // 1.2^2 = 1.44: 0.31 of the energy in play is new, beyond 0.05 + 2 dt/critical
    EXPECT_NE(r.trouble.reason.find("particle 7"), std::string::npos);
    EXPECT_NE(r.trouble.reason.find("h/(c + |v|)"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(plan.folder + "/particles_last_good.csv"));
}

TEST_F(Run, EnergyThatWorkExplainsIsNoTrouble) {
    sim.step = [this](double, double) { energy += 1; };
    sim.supply = [](double, double) { return Supply{{0, 0}, 1}; };
    const RunResult r = run(sim, plan);
    EXPECT_TRUE(r.ok());
    EXPECT_NEAR(r.energy_drift, 0, 1e-15);
}

TEST_F(Run, EnergyThatWorkDoesNotExplainIsTrouble) {
    sim.step = [this](double, double) { energy += 3; };
    sim.supply = [](double, double) { return Supply{{0, 0}, 1}; };
    EXPECT_EQ(run(sim, plan).trouble.cause, "energy-growth");
}

TEST_F(Run, EnergyThatSwingsIsNoTrouble) {
    plan.steps = 1000, plan.dt = plan.critical_dt = 1e-3;
    sim.step = [this](double t, double dt) {
        energy = 1.1 + 0.1 * std::sin(2 * 3.14159 * (t / dt) / 63);
    };  // as a stable leapfrog's with 126 steps a period
    EXPECT_TRUE(run(sim, plan).ok());
}
TEST_F(Run, EnergyThatStaysHighIsTrouble) {
    plan.steps = 1000, plan.dt = plan.critical_dt = 1e-3;
    sim.step = [this](double t, double) { energy = t > 0.5 ? 1.1 : 1; };
    const RunResult r = run(sim, plan);
    EXPECT_EQ(r.trouble.cause, "energy-growth");
    EXPECT_NEAR(r.t_fail, 0.664, 2e-3);  // a record every 200 steps, then the watch's patience
}

TEST_F(Run, LostEnergyIsReportedAndNotStopped) {
    sim.step = [this](double, double) { energy *= 0.5; };
    const RunResult r = run(sim, plan);
    EXPECT_TRUE(r.ok());
    EXPECT_NEAR(r.energy_drift, std::pow(0.5, 10) - 1, 1e-12);
}

TEST_F(Run, EnergyThatIsNoNumberIsNamed) {
    sim.step = [this](double t, double) {
        if (t > 0.45) energy = std::numeric_limits<double>::quiet_NaN();
    };
    const RunResult r = run(sim, plan);
    EXPECT_EQ(r.trouble.cause, "not-finite");
    EXPECT_NEAR(r.t_fail, 0.6, 1e-12);
}

TEST_F(Run, ALeftGridIsNamed) {
    sim.step = [](double t, double) {
        if (t > 0.25) throw OutsideGrid("position 3 outside the grid");
    };
    const RunResult r = run(sim, plan);
    EXPECT_EQ(r.trouble.cause, "left-grid");
    EXPECT_EQ(restored, 1);
}

TEST_F(Run, WatchWarnGoesOnAndSaysSoAtTheEnd) {
    plan.stop_on_trouble = false;
    sim.inspect = [] { return Trouble{"numerical-fracture", "a gap"}; };
    const RunResult r = run(sim, plan);
    EXPECT_EQ(r.trouble.cause, "numerical-fracture");
    EXPECT_NEAR(r.t_fail, 0.2, 1e-12);
    EXPECT_FALSE(r.stopped);
    EXPECT_EQ(r.t, 1);
}

TEST_F(Run, MomentumIsBalancedAgainstImpulse) {
    double p = 0;
    sim.measure = [&] {
        Measures m;
        m.kinetic = 1, m.momentum = {p, 0}, m.momentum_in_play = 2;
        return m;
    };
    sim.step = [&](double, double dt) { p += 3 * dt; };
    sim.supply = [](double, double dt) { return Supply{{2 * dt, 0}, 0}; };
    EXPECT_NEAR(run(sim, plan).momentum_drift, 0.5, 1e-12);  // gained 3, told of 2, of 2 in play
}

}  // namespace
}  // namespace mpm
