// `--threads` from the command line to a whole run in two dimensions, with particles that may change places.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "chapters/weighting/assemble_with.hpp"

namespace mpm {
namespace {

/// A free square that stretches and drifts; its particles are numbered at random.
struct Square {
    static constexpr int D = 2;
    static constexpr const char *name = "square", *reference = "none";
    using Law = NeoHookean;

    Law law() const { return {0.4, 0.3, 1.0}; }
    double speed() const { return 0.15; }
    double wave_speed() const { return law().wave_speed(); }
    Lattice<2> lattice(int cells, int per_cell) const {
        return {Vec<2>::Constant(-0.5), Vec<2>::Constant(1.0 / cells), {2 * cells, 2 * cells}, per_cell};
    }
    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        std::vector<Point> all;
        for (int j = 0; j < cells * ppc; ++j)
            for (int i = 0; i < cells * ppc; ++i) {
                Point& p = all.emplace_back();
                p.X = p.x = Vec<2>(i + 0.5, j + 0.5) / (cells * ppc);
                p.m = p.V = p.V0 = 1.0 / (cells * ppc * cells * ppc);
                p.v = Vec<2>(0.05 + 0.05 * std::cos(3 * p.x[0]), 0.1);
            }
        std::shuffle(all.begin(), all.end(), std::mt19937(5));
        return all;
    }
    template <class Body> void load(Body&, double) const {}
    template <class Grid, class Field> void fix(Grid&, Field, double) const {}
    template <class Points> std::vector<double> watch(const Points&, double) const { return {}; }

    struct Observer {
        const Square& scene;
        template <class Points> void sample(const Points&, double, double) const {}
        bool wants_energy(double, double) const { return false; }
        std::vector<NamedError> errors(double) const { return {}; }
        std::vector<std::pair<std::string, double>> facts(double) const { return {}; }
    };
};
struct NumberedSquare : Square {
    static constexpr bool numbered = true;
};

/// The last snapshot and the sums at the end of 100 steps.
struct End {
    std::vector<std::vector<double>> particles;
    Measures sums;
    int threads = 0;
};
template <class Scene> End end_of_run(int threads) {
    Common common;
    common.ppc = 2;
    common.threads = threads;
    Assembled a = assemble_with<Quadratic, false>(Musl{}, Scene{}, Flip{}, 24, common);
    const std::string folder = testing::TempDir() + "threads_of_a_run";
    std::filesystem::create_directories(folder);
    RunPlan plan = whole_steps(1.0, 0.01, a.critical_dt);
    plan.dim = 2, plan.frames = 1, plan.folder = folder;
    const RunResult result = run(a.simulation, plan);
    EXPECT_TRUE(result.ok()) << result.trouble.reason;
    std::ifstream file(folder + "/particles_0001.csv");
    std::string line;
    std::getline(file, line);
    End end{{}, a.simulation.measure(), a.row.threads};
    while (std::getline(file, line)) {
        std::istringstream cells(line);
        std::vector<double>& row = end.particles.emplace_back();
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    }
    return end;
}

TEST(ThreadsOfARun, StateDoesNotDependOnThreadsNorOnTheOrderOfParticles) {
    const End plain = end_of_run<NumberedSquare>(1), one = end_of_run<Square>(1), two = end_of_run<Square>(2);
    EXPECT_EQ(one.threads, 1);
    EXPECT_EQ(two.threads, 2);
    ASSERT_EQ(plain.particles.size(), 48u * 48u);
    for (const End* other : {&one, &two}) {
        ASSERT_EQ(other->particles.size(), plain.particles.size());
        for (std::size_t i = 0; i < plain.particles.size(); ++i)
            for (std::size_t k = 0; k < plain.particles[i].size(); ++k)
                ASSERT_NEAR(other->particles[i][k], plain.particles[i][k], 1e-12);  // 100 steps of roundings on values of order one
        EXPECT_NEAR(other->sums.kinetic, plain.sums.kinetic, 1e-13);
        EXPECT_NEAR(other->sums.strain, plain.sums.strain, 1e-13);
    }
}

int threads_of(const std::vector<const char*>& words, bool two_dimensional) {
    Options options("square", "a test");
    Common common;
    common.declare(options, {"hat"}, 1);
    if (two_dimensional) common.declare_threads(options);
    options.parse(static_cast<int>(words.size()), words.data());
    return common.threads;
}
std::string refusal(const std::vector<const char*>& words, bool two_dimensional) {
    try {
        threads_of(words, two_dimensional);
    } catch (const BadInput& bad) {
        return bad.what();
    }
    return "none";
}
TEST(ThreadsOption, IsOneUnlessTold) {
    EXPECT_EQ(threads_of({"square"}, true), 1);
    EXPECT_EQ(threads_of({"square", "--threads", "2"}, true), 2);
}
TEST(ThreadsOption, HasARangeAndIsUnknownInOneDimension) {
    EXPECT_NE(refusal({"square", "--threads", "0"}, true).find("--threads"), std::string::npos);
    EXPECT_NE(refusal({"square", "--threads", "257"}, true).find("256"), std::string::npos);
    EXPECT_NE(refusal({"bar", "--threads", "2"}, false).find("--threads"), std::string::npos);
}

}  // namespace
}  // namespace mpm
