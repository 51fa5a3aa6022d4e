// Moving rigid bodies: their motion, the nodes they hold, what they give to a body.
#include "lab/rigid_body.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/chapters/explicit/problem.hpp"

namespace mpm::test {
namespace {

const NeoHookean soft{30, 20, 1};

TEST(Ramp, MovesByTheIntegralOfItsVelocity) {
    const Ramp<2> ramp{Vec<2>(0.3, -2), 1.5};
    Vec<2> sum = Vec<2>::Zero();
    const double dt = 1e-3;
    for (int k = 0; k < 2500; ++k) sum += dt * ramp.velocity((k + 0.5) * dt);
    EXPECT_LT((sum - ramp.displacement(2.5)).norm(), 1e-6);  // midpoint rule: dt^2 times the second derivative, about 3
    EXPECT_EQ(ramp.velocity(0), (Vec<2>(0, 0)));
    EXPECT_EQ(ramp.velocity(1.5), ramp.v0);
    EXPECT_EQ((Ramp<2>{Vec<2>(1, 2), 0}.displacement(3)), (Vec<2>(3, 6)));  // (4.7)
}

/// Sides of nodes that a rigid particle in the middle of cell (4, 4) of 9 x 9 holds, after `t`.
template <class Body> std::set<int> held_nodes(const Body& body, double t) {
    Grid<2, Node<2>> grid(Lattice<2>(Vec<2>(0, 0), Vec<2>(1, 1), {9, 9}));
    for (auto& node : grid) node.m = 1, node.mv = Vec<2>(7, 7);
    body.apply(grid, &Node<2>::mv, t);
    std::set<int> held;
    for (int I = 0; I < grid.size(); ++I)
        if (grid[I].mv != Vec<2>(7, 7)) held.insert(I);
    return held;
}
TEST(RigidBody, HoldsTheNodesOfTheElementsThatItsParticlesAreIn) {
    RigidBody<2> body({Vec<2>(4.5, 4.5)}, {Vec<2>(0, -1)});
    EXPECT_EQ(held_nodes(body, 0), (std::set<int>{44, 45, 54, 55}));
    EXPECT_EQ(held_nodes(body, 0.4), held_nodes(body, 0));
    EXPECT_EQ(held_nodes(body, 0.6), (std::set<int>{34, 35, 44, 45}));
    EXPECT_TRUE(held_nodes(body, 6).empty());  // it has left the grid
    body.reach = 1;
    EXPECT_EQ(held_nodes(body, 0).size(), 16u);
}
TEST(RigidBody, SlipsAlongItself) {
    RigidBody<2> body({Vec<2>(4.5, 4.5)}, {Vec<2>(0.5, -1)});
    body.normal = 1;
    Grid<2, Node<2>> grid(Lattice<2>(Vec<2>(0, 0), Vec<2>(1, 1), {9, 9}));
    grid[44].m = 2;
    grid[44].mv = Vec<2>(3, 3);
    body.apply(grid, &Node<2>::mv, 0);
    EXPECT_EQ(grid[44].mv, (Vec<2>(3, -2)));
}

/// A block and a rigid body, in a grid of cells of .25.
struct Pushed {
    RigidBody<2> body{};
    Vec<2> impulse = Vec<2>::Zero();
    double work = 0;
    template <class B> void load(B&, double) const {}
    template <class G, class Field> void fix(G& grid, Field field, double t) const { body.apply(grid, field, t); }
    template <class G> void add(const G& grid, double t, double dt) {
        const Supply s = body.supply(grid, t, dt);
        impulse += Vec<2>(s.impulse[0], s.impulse[1]);
        work += s.work;
    }
};
/// Rigid particles in the cells of rows [low, high), as wide as the grid of 12 cells.
void fill_rows(RigidBody<2>& body, int low, int high) {
    for (int j = 2 * low; j < 2 * high; ++j)
        for (int i = 0; i < 24; ++i) body.X.emplace_back((i + 0.5) * 0.125, (j + 0.5) * 0.125);
}

template <class Scheme, class Kernel> void a_block_moves_with_it() {
    Problem<2, Scheme, NeoHookean, Kernel> s;
    s.add(soft, 3, 2, 4, 12, 0.25);
    Pushed scene;
    scene.body.reach = RigidBody<2>::reach_of(Kernel::support);
    scene.body.motion.v0 = Vec<2>(0.3, -0.2);
    fill_rows(scene.body, 2, 10);
    for (auto& p : s.points()) p.v = scene.body.motion.v0;
    for (int k = 0; k < 200; ++k) s.scheme.step(s.bodies, Free{}, scene, 0.005 * k, 0.005);
    for (const auto& p : s.points()) {
        EXPECT_LT((p.x - p.X - scene.body.motion.v0).norm(), 1e-12);  // rounding of 200 sums
        EXPECT_LT((p.F - identity<2>()).norm(), 1e-12);
    }
}
TEST(RigidBody, CarriesAWeldedBlock) {
    a_block_moves_with_it<Usl, Hat>();
    a_block_moves_with_it<Usf, Hat>();
    a_block_moves_with_it<Musl, Hat>();
    a_block_moves_with_it<Musl, Ugimp>();
    a_block_moves_with_it<Musl, Quadratic>();
    a_block_moves_with_it<Musl, Cubic>();
}

/// What is missing in the balances of a block at rest that a platen has pushed, in parts of the impulse and of the work.
struct Balance {
    double momentum, energy;
};
constexpr double constant = 0, ramp = 0.4;  // time in which the platen reaches its velocity
constexpr double near = 0.05, far = 0.4;    // its way: within the cells where it began, and through two
constexpr double rounding = 1e-12;
template <class Scheme, class Kernel = Hat> Balance press(double dt, double rise, double way, double alpha = 1) {
    Problem<2, Scheme, NeoHookean, Kernel> s;
    s.add(soft, 4, 2, 4, 12, 0.25);  // top at y = 2
    s.bodies[0].transfer.alpha = alpha;
    Pushed scene;
    scene.body.reach = RigidBody<2>::reach_of(Kernel::support);
    scene.body.motion = {Vec<2>(0.1, -0.6), rise};
    fill_rows(scene.body, 8, 11);
    const double t_end = rise / 2 + way / 0.6;
    const int steps = static_cast<int>(std::lround(t_end / dt));
    for (int k = 0; k < steps; ++k) {
        s.scheme.step(s.bodies, Free{}, scene, k * dt, dt);
        scene.add(s.bodies[0].grid, (k + 1) * dt, dt);
    }
    const Measures now = measure(s.bodies);
    return {(s.momentum() - scene.impulse).norm() / scene.impulse.norm(), (now.total() - scene.work) / scene.work};
}
TEST(RigidBody, GivesTheMomentumThatABodyGains) {
    EXPECT_LT(press<Usl>(0.005, constant, near).momentum, rounding);
    EXPECT_LT((press<Musl, Cubic>(0.005, ramp, far).momentum), rounding);
    for (const double rise : {constant, ramp})
        for (const double way : {near, far}) {
            EXPECT_LT(press<Usf>(0.005, rise, way).momentum, rounding);
            EXPECT_LT(press<Musl>(0.005, rise, way).momentum, rounding);
        }
}
// PIC takes besides what nodes held at t had gathered, which no node remembers.
TEST(RigidBody, KnowsNothingOfWhatPicTakes) { EXPECT_GT(press<Musl>(0.005, constant, near, 0.9).momentum, 1e-3); }

template <class Scheme, class Kernel = Hat> double energy_ratio(double dt) {
    return press<Scheme, Kernel>(dt, constant, near).energy / press<Scheme, Kernel>(dt / 2, constant, near).energy;
}
// At constant velocity, as long as it holds no further nodes, the energy balance closes with the first order of the time step.
TEST(RigidBody, DoesTheWorkThatABodyGains) {
    EXPECT_NEAR(energy_ratio<Usl>(0.001), 2, 0.15);
    EXPECT_NEAR(energy_ratio<Usf>(0.001), 2, 0.15);
    EXPECT_NEAR(energy_ratio<Musl>(0.001), 2, 0.15);
    EXPECT_NEAR((energy_ratio<Musl, Cubic>(0.001)), 2, 0.15);
    EXPECT_LT(std::abs(press<Musl>(0.0005, constant, near).energy), 2e-3);
}
// Nodes that become held lose energy as in an inelastic impact, and a body whose velocity changes does not find that of the particles: a
// loss that smaller steps do not mend, never a gain.
TEST(RigidBody, LosesEnergyWhereItTakesHold) {
    for (const double rise : {constant, ramp}) {
        const double loss = -press<Musl>(0.001, rise, far).energy;
        EXPECT_GT(loss, 0);
        EXPECT_LT(loss, 0.06);
        EXPECT_NEAR(-press<Musl>(0.0005, rise, far).energy, loss, 0.1 * loss);
    }
}

}  // namespace
}  // namespace mpm::test
