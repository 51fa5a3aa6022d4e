// Held nodes, moving held nodes, and planes of symmetry.
#include "lab/boundary.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "tests/chapters/explicit/problem.hpp"

namespace mpm::test {
namespace {

const NeoHookean soft{30, 20, 1};

struct Circle {
    Vec<2> centre;
    double radius;
    bool inside(const Vec<2>& x) const { return (x - centre).norm() <= radius; }
};

TEST(Dirichlet, HoldsTheNodesInsideAShapeAndTheOthersOutside) {
    const Lattice<2> lattice(Vec<2>(0, 0), Vec<2>(0.5, 0.5), {6, 6});
    const Circle circle{{1.5, 1.5}, 0.6};
    Dirichlet in, out;
    in.hold_inside(lattice, circle, 1, 2.0);
    out.hold_outside(lattice, circle, 1);
    EXPECT_EQ(in.held.size(), 5u);  // the centre and its four neighbours
    EXPECT_EQ(in.held.size() + out.held.size(), static_cast<std::size_t>(lattice.size()));
    for (const auto& [I, axis, v] : in.held) {
        EXPECT_TRUE(circle.inside(lattice.position(I)));
        EXPECT_EQ(axis, 1);
        EXPECT_EQ(v, 2);
    }
}

TEST(Dirichlet, TakesTheLastWordOnANode) {
    Dirichlet d;
    d.hold(3, 0, 1);
    d.hold(1, 1, 2);
    d.hold(3, 1, 3);
    d.hold(3, 0, 4);
    ASSERT_EQ(d.held.size(), 3u);
    EXPECT_EQ(d.held[1].node, 3);
    EXPECT_EQ(d.held[1].v, 4);
}

/// Holds the left side of a square at a velocity that grows with time, and adds up what that gives.
struct Pulled {
    Dirichlet side;
    static double factor(double t) { return 3 * t * t; }
    template <class B> void load(B&, double) const {}
    template <class G, class Field> void fix(G& grid, Field field, double t) const { side.apply(grid, field, factor(t)); }
};

template <class Scheme> void momentum_comes_from_the_held_nodes() {
    Problem<2, Scheme, NeoHookean> s;
    s.add(soft, 4, 2, 2, 9, 0.25);
    Pulled scene;
    scene.side.hold_plane(s.lattice, 0, 0.5, true, 0, 0.4);
    scene.side.hold_plane(s.lattice, 0, 0.5, true, 1, -0.2);
    Vec<2> given = Vec<2>::Zero();
    const double dt = 0.005;
    for (int k = 0; k < 100; ++k) {
        const double t = k * dt;
        s.scheme.step(s.bodies, Free{}, scene, t, dt);
        const Supply sum = scene.side.supply(s.bodies[0].grid, dt, Pulled::factor(t + dt));
        given += Vec<2>(sum.impulse[0], sum.impulse[1]);
    }
    EXPECT_GT(given.norm(), 0.05);
    EXPECT_LT((s.momentum() - given).norm(), 1e-13 * 100);  // rounding of 100 sums of order one
}
TEST(Dirichlet, MovingNodesGiveTheMomentumThatABodyGains) {
    momentum_comes_from_the_held_nodes<Usl>();
    momentum_comes_from_the_held_nodes<Usf>();
    momentum_comes_from_the_held_nodes<Musl>();
}

/// Holds a plane of symmetry, or nodes, or nothing.
struct Middle {
    std::optional<SymmetryPlane<2>> plane{};
    Dirichlet nodes{};
    template <class B> void load(B&, double) const {}
    template <class G, class Field> void fix(G& grid, Field field, double) const {
        if (plane) plane->apply(grid, field);
        nodes.apply(grid, field);
    }
};
Lattice<2> grid_from(int cells_beyond) { return {Vec<2>(2 - 0.25 * cells_beyond, 0), Vec<2>(0.25, 0.25), {8 + cells_beyond, 16}}; }

/// Places, at the end, of those particles of a stretching square that lie beyond its middle line x = 2; or of that half alone.
template <class Scheme, class Kernel> std::vector<Vec<2>> stretched(bool half, int cells_beyond, const Middle& scene) {
    using P = Problem<2, Scheme, NeoHookean, Kernel>;
    P s;
    const double h = 0.25;
    s.lattice = grid_from(cells_beyond);
    std::vector<typename P::Point> points;
    for (int j = 0; j < 16; ++j)
        for (int i = half ? 0 : -8; i < 8; ++i) {
            typename P::Point p;
            p.x = p.X = Vec<2>(2 + (i + 0.5) * h / 2, 1 + (j + 0.5) * h / 2);
            p.m = p.V = p.V0 = h * h / 4;
            p.v = Vec<2>(0.5 * std::sin(p.x[0] - 2), 0.3 * std::cos(2 * (p.x[0] - 2)) * p.x[1]);
            points.push_back(p);
        }
    s.add_points(soft, points, 2);
    for (int k = 0; k < 60; ++k) s.scheme.step(s.bodies, Free{}, scene, 0.005 * k, 0.005);
    std::vector<Vec<2>> x;
    for (const auto& p : s.points())
        if (p.X[0] > 2) x.push_back(p.x);
    return x;
}
template <class Scheme, class Kernel> double off_the_whole(int cells_beyond, const Middle& scene) {
    const auto whole = stretched<Scheme, Kernel>(false, 8, {});
    const auto half = stretched<Scheme, Kernel>(true, cells_beyond, scene);
    double largest = 0;
    for (std::size_t i = 0; i < half.size(); ++i) largest = std::max(largest, (half[i] - whole[i]).norm());
    return largest;
}
template <class Scheme, class Kernel> double with_plane(int cells_beyond) {
    return off_the_whole<Scheme, Kernel>(cells_beyond, {SymmetryPlane<2>(grid_from(cells_beyond), 0, 2.0)});
}
/// What one would hold with hat functions: the normal velocity on the line and beyond.
template <class Scheme, class Kernel> double with_normal_held(int cells_beyond) {
    Middle scene;
    scene.nodes.hold_plane(grid_from(cells_beyond), 0, 2.0, true, 0);
    return off_the_whole<Scheme, Kernel>(cells_beyond, scene);
}

constexpr double rounding = 1e-12;  // of lengths of order one after 60 steps; the displacements are .1

TEST(SymmetryPlane, HalfABodyMovesAsTheWholeDoes) {
    EXPECT_LT((with_plane<Usl, Hat>(0)), rounding);
    EXPECT_LT((with_plane<Usf, Hat>(0)), rounding);
    EXPECT_LT((with_plane<Musl, Hat>(0)), rounding);
    EXPECT_LT((with_plane<Musl, Hat>(3)), rounding);
    EXPECT_LT((with_normal_held<Musl, Hat>(3)), rounding);
}
TEST(SymmetryPlane, WideFunctionsNeedTheirMirrorImage) {
    EXPECT_LT((with_plane<Musl, Ugimp>(1)), rounding);
    EXPECT_LT((with_plane<Musl, Cpgimp>(1)), rounding);
    EXPECT_LT((with_plane<Musl, Quadratic>(1)), rounding);
    EXPECT_LT((with_plane<Musl, Cubic>(1)), rounding);
    EXPECT_LT((with_plane<Usl, Cubic>(1)), rounding);
    EXPECT_LT((with_plane<Usf, Cubic>(1)), rounding);
}
// Neither holding the normal velocity nor ending the grid at the plane is symmetry for them: both miss by parts of the displacement, .1.
TEST(SymmetryPlane, HoldingTheNormalVelocityAloneIsNoSymmetryForWideFunctions) {
    EXPECT_GT((with_normal_held<Musl, Cubic>(3)), 1e-4);
    EXPECT_GT((with_plane<Musl, Cubic>(0)), 1e-4);
    EXPECT_GT((with_normal_held<Musl, Quadratic>(3)), 1e-4);
}

template <class Kernel> void plane_bears_what_momentum_lacks() {
    Problem<2, Musl, NeoHookean, Kernel> s;
    s.add(soft, 4, 2, 3, 10, 0.25);
    for (auto& p : s.points()) p.v = Vec<2>(-0.5, 0.2 * p.x[0]);
    const SymmetryPlane<2> plane(s.lattice, 0, 0.75);
    const Middle scene{plane};
    const Vec<2> before = s.momentum();
    Vec<2> given = Vec<2>::Zero();
    for (int k = 0; k < 80; ++k) {
        s.scheme.step(s.bodies, Free{}, scene, 0, 0.005);
        given -= 0.005 * plane.held_force(s.bodies[0].grid);
    }
    EXPECT_GT(given[0], 0.1);
    EXPECT_LT((s.momentum() - before - given).norm(), 1e-12);  // rounding
}
TEST(SymmetryPlane, BearsTheNormalMomentumThatTheBodyLoses) {
    plane_bears_what_momentum_lacks<Hat>();
    plane_bears_what_momentum_lacks<Cubic>();
}

TEST(SymmetryPlane, LiesOnAGridLine) {
    const Lattice<2> lattice(Vec<2>(0, 0), Vec<2>(0.5, 0.5), {4, 4});
    EXPECT_NO_THROW(SymmetryPlane<2>(lattice, 1, 1.5));
    EXPECT_THROW(SymmetryPlane<2>(lattice, 1, 1.25), std::invalid_argument);
    EXPECT_THROW(SymmetryPlane<2>(lattice, 0, 2.5), std::invalid_argument);
}

}  // namespace
}  // namespace mpm::test
