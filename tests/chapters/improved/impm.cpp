// The improved MPM: what its pieces reproduce, and what it conserves.
#include "chapters/improved/impm.hpp"

#include <gtest/gtest.h>

#include "chapters/weighting/quadratic.hpp"
#include "tests/chapters/explicit/problem.hpp"

namespace mpm::test {
namespace {

const NeoHookean soft{30, 20, 1};

/// Largest difference between gradient_between_cells and the exact gradient of a field on a grid of 6 x 5 cells, of which those below
/// `filled` along the first axis hold material.
template <class Field, class Exact> double gradient_error(const Field& field, const Exact& exact, int filled = 6) {
    Grid<2, Node<2>> grid(Lattice<2>(Vec<2>(-1, 2), Vec<2>(0.5, 0.2), {6, 5}));
    const Lattice<2>& lattice = grid.lattice();
    for (int I = 0; I < grid.size(); ++I) {
        if (lattice.along(I, 0) > filled) continue;
        grid[I].m = 1;
        grid[I].v_new = field(lattice.position(I));
    }
    double largest = 0;
    for (double a = 0; a < filled; a += 0.0625)  // on the last edge a particle is in the next cell
        for (double b = 0; b <= 5; b += 0.125) {
            const Vec<2> x = lattice.origin() + Vec<2>(a, b).cwiseProduct(lattice.h());
            largest = std::max(largest, (gradient_between_cells<2>(grid, x) - exact(x)).template lpNorm<Eigen::Infinity>());
        }
    return largest;
}

// The differences along edges are exact in their middles for squares, and so is what lies linearly between and beyond them.
TEST(ImpmGradient, IsExactForSquaresUpToTheEnds) {
    const auto field = [](const Vec<2>& x) { return Vec<2>(1 + x[0] * x[0] - 2 * x[1], 3 * x[0] * x[1] + x[1] * x[1]); };
    const auto exact = [](const Vec<2>& x) {
        Mat<2> L;
        L << 2 * x[0], -2, 3 * x[1], 3 * x[0] + 2 * x[1];
        return L;
    };
    EXPECT_LT(gradient_error(field, exact), 1e-12);
    EXPECT_LT(gradient_error(field, exact, 4), 1e-12) << "cells without material have no say";
    EXPECT_LT(gradient_error(field, exact, 2), 1e-12);
}
TEST(ImpmGradient, IsThatOfTheCellWhereNoOtherIs) {
    const auto field = [](const Vec<2>& x) { return Vec<2>(x[0] + 2 * x[1], 0); };
    const auto exact = [](const Vec<2>&) {
        Mat<2> L;
        L << 1, 2, 0, 0;
        return L;
    };
    EXPECT_LT(gradient_error(field, exact, 1), 1e-12);
}
// Inside a body on a line the mended gradient is the quadratic B-spline's.
TEST(ImpmGradient, IsTheQuadraticSplinesOnALine) {
    Grid<1, Node<1>> grid(Lattice<1>(Vec<1>(0.0), Vec<1>(0.5), {8}));
    for (int I = 0; I < grid.size(); ++I) grid[I].m = 1, grid[I].v_new[0] = std::sin(1.7 * I);
    const Tensor<1, Quadratic> spline{grid.lattice(), {}};
    for (double x = 0.26; x < 3.74; x += 0.01) {
        double L = 0;
        for (const auto& e : spline.at(Vec<1>(x), 0)) L += grid[e.node].v_new[0] * e.grad[0];
        EXPECT_NEAR(gradient_between_cells<1>(grid, Vec<1>(x))(0, 0), L, 1e-13) << x;
    }
}

/// A free square or bar of 4 cells a side, anywhere in its cells.
template <int D> auto free_body(double shift, const ImpmChoice& choice = {}) {
    Problem<D, Impm<D>, NeoHookean> s;
    static_cast<ImpmChoice&>(s.scheme) = choice;
    s.scheme.mls.support = 1.5;
    s.add(soft, 4, 2, 3, 10, 0.25);
    for (auto& p : s.points()) p.x += Vec<D>::Constant(shift), p.X = p.x;
    return s;
}
template <int D> double grid_mass(double shift, const std::string& surface) {
    ImpmChoice choice;
    choice.surface = surface;
    auto s = free_body<D>(shift, choice);
    s.run(1, 1e-6);
    double mass = 0;
    for (const auto& node : s.bodies[0].grid) mass += node.m;
    return mass;
}
TEST(ImpmMass, OfAFreeBodyIsThatOfItsParticlesWhereverItLies) {
    for (const double shift : {0.0, 0.01, 0.06, 0.0625, 0.07, 0.13, 0.2, 0.24}) {
        EXPECT_NEAR(grid_mass<1>(shift, "part"), 1, 1e-13) << shift;  // rounding of 16 particles' and 10 cells' sums
        EXPECT_NEAR(grid_mass<2>(shift, "part"), 1, 1e-13) << shift;
    }
    EXPECT_NEAR(grid_mass<1>(0.13, "whole"), 1.25, 1e-13) << "five cells";
    EXPECT_NEAR(grid_mass<2>(0.13, "whole"), 1.5625, 1e-13) << "five times five";
}

template <int D> void expect_flight_undisturbed(const std::string& surface, const std::string& quadrature) {
    ImpmChoice choice;
    choice.surface = surface;
    choice.quadrature = quadrature;
    auto s = free_body<D>(0.03, choice);
    const Vec<D> v = Vec<D>::LinSpaced(0.7, 0.4);
    for (auto& p : s.points()) p.v = v;
    s.run(200, 0.002);  // more than a cell
    for (const auto& p : s.points()) {
        ASSERT_LT((p.v - v).norm(), 1e-12);
        ASSERT_LT((p.x - p.X - 0.4 * v).norm(), 1e-12);
        ASSERT_LT(p.sigma.norm(), 1e-11);  // stiffness times the roundings of 200 steps over h
    }
}
TEST(ImpmFlight, IsUndisturbedOnALine) { expect_flight_undisturbed<1>("part", "centre"); }
TEST(ImpmFlight, IsUndisturbedInThePlane) {
    for (const char* surface : {"part", "whole"})
        for (const char* quadrature : {"centre", "gauss"}) expect_flight_undisturbed<2>(surface, quadrature);
}

// A velocity field linear in space, as of a spinning or stretching body, is kept but for the stress of one step.
TEST(ImpmLinearField, IsKeptWithItsGradient) {
    auto s = free_body<2>(0.04);
    s.scheme.mls.limit = 1e4;  // corners are extrapolated
    Mat<2> C;
    C << 0.3, -0.2, 0.5, 0.1;
    for (auto& p : s.points()) p.v = C * p.x;
    s.run(1, 1e-7);
    for (const auto& p : s.points()) {
        EXPECT_LT((p.v - C * p.X).norm(), 1e-10);
        EXPECT_LT(((p.F - identity<2>()) / 1e-7 - C).norm(), 1e-7);
    }
}

// Nodal velocities are no momenta over masses, so a vibrating body's momentum is kept only as far as the fits are good.
TEST(ImpmMomentum, IsNotConservedExactly) {
    auto s = free_body<2>(0.04);
    for (auto& p : s.points()) p.v = Vec<2>(0.3 * std::sin(3 * p.X[0]), 0.1 * std::cos(4 * p.X[1]));
    double in_play = 0;
    for (const auto& p : s.points()) in_play += p.m * p.v.norm();
    const Vec<2> before = s.momentum();
    s.run(200, 0.002);
    const double lost = (s.momentum() - before).norm() / in_play;
    EXPECT_GT(lost, 1e-6);
    EXPECT_LT(lost, 0.05);
}

TEST(ImpmThreads, GiveTheSameResult) {
    const auto run = [](int threads) {
        auto s = free_body<2>(0.04);
        s.bodies[0].grid.use_threads(threads);
        for (auto& p : s.points()) p.v = Vec<2>(0.3 * std::sin(3 * p.X[0]), 0.1 * std::cos(4 * p.X[1]));
        s.run(50, 0.002);
        return s.points();
    };
    const auto one = run(1), two = run(2), three = run(3);
    for (std::size_t i = 0; i < one.size(); ++i) {
        ASSERT_EQ(one[i].x, two[i].x);  // every sum is made by one thread, in one order
        ASSERT_EQ(two[i].x, three[i].x);
        ASSERT_EQ(one[i].sigma, three[i].sigma);
    }
}

}  // namespace
}  // namespace mpm::test
