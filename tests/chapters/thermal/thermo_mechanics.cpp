// Thermo-mechanics (Algorithm 9): exact stresses, strains and temperatures, and what it shares with MUSL.
#include "chapters/thermal/thermo_mechanics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "chapters/scenes/expanding_body.hpp"
#include "tests/chapters/thermal/hot_run.hpp"
#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

// Even heating moves nothing: the stress is the sum of equal steps, to rounding.
TEST(ThermoMechanics, ClampedBarHeatedEvenly) {
    ExpandingSettings s;
    s.heating = "uniform";
    const Ran r = ran(ExpandingBody<1>(s, 5), 10, 0.5);
    EXPECT_LT(r.errors.at("stress_max"), 1e-12);
}

// The mean stress follows the mean temperature of the series; waves of the sudden start (heat needs 1000 times as long as sound to cross
// the bar) and the error of the nodes' temperatures on 20 cells are below 1e-3.
TEST(ThermoMechanics, ClampedBarHeatedAtItsEnd) { EXPECT_LT(ran(ExpandingBody<1>({}, 20), 20, 0.5).errors.at("stress_ripple"), 1e-3); }

// The particles start half a step ahead of what they strain, 1e-4 of the run.
TEST(ThermoMechanics, FreePlateExpandsWithoutStress) {
    ExpandingSettings s;
    s.plane = true;
    const Ran r = ran(ExpandingBody<2>(s, 10), 5, 0.5);
    EXPECT_LT(r.errors.at("strain"), 1e-3);
    EXPECT_LT(r.errors.at("stress_max"), 2e-3);
}

/// A shaken bar, heated at its left end, for both schemes.
struct Shaken : FreeScene {
    static constexpr int D = 1;
    template <class Body> void heat(Body&, double) const {}
    template <class Grid, class Field> void hold(Grid& grid, Field field, double) const { grid[1].*field = 5; }
};
template <class Scheme, class Law> std::vector<double> shaken(const Law& law) {
    using Node = NodeFor<Scheme, Flip, 1>;
    using P = PointFor<Scheme, Law, Flip, 1>;
    using Bar = Body<1, P, Node, Law, Tensor<1, Hat>, Flip>;
    const Lattice<1> lattice(Vec<1>(0.0), Vec<1>(1.0), {6});
    std::vector<P> points(8);
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].x[0] = points[i].X[0] = 1.25 + 0.5 * static_cast<double>(i);
        points[i].m = points[i].V = points[i].V0 = 0.5;
        points[i].v[0] = std::sin(points[i].x[0]);
    }
    std::vector<Bar> bodies;
    bodies.push_back({{points, Grid<1, Node>(lattice), law}, {lattice}, {}});
    const Shaken scene;
    for (int i = 0; i < 50; ++i) Scheme{}.step(bodies, Free{}, scene, 0.05 * i, 0.05);
    std::vector<double> all;
    for (const P& p : bodies[0].points) all.insert(all.end(), {p.x[0], p.v[0], p.F(0, 0), p.sigma(0, 0)});
    return all;
}

TEST(ThermoMechanics, WithoutExpansionMovesAsMusl) {
    Conducting<ThermoElastic> hot;
    hot.mu = 0.5, hot.k = 0.1;
    LinearElastic cold;
    cold.mu = 0.5;
    EXPECT_EQ(shaken<ThermoMechanics>(hot), shaken<Musl>(cold));
    hot.alpha = 1e-3;
    EXPECT_NE(shaken<ThermoMechanics>(hot), shaken<Musl>(cold));
}

TEST(ThermoMechanicsPrograms, BalanceTheirEnergies) {
    const Folder folder;
    EXPECT_EQ(folder.run("adiabatic_shear", {"--t-end", "2e-5", "--quiet", "--out", "run"}).code, 0);
    const auto summary = csv(folder.read("run/summary.csv"));
    EXPECT_LT(std::abs(std::stod(field(summary, 1, "energy_drift"))), 1e-3);  // a step's error in the elastic range
    EXPECT_EQ(folder.run("thermal_bar_clamped", {"--heating", "uniform", "--t-end", "1", "--quiet", "--out", "bar"}).code, 0);
    EXPECT_LT(std::abs(std::stod(field(csv(folder.read("bar/summary.csv")), 1, "energy_drift"))), 1e-9);
}

}  // namespace
}  // namespace mpm::test
