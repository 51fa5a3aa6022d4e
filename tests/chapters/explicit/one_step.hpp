/// One step of a scheme against what it must do exactly: each numbered line of a scheme changes one of these results. A file for each
/// scheme instantiates them, so that a mutant of one (tests/mutants) is soon compiled.
#pragma once
#include <gtest/gtest.h>

#include "tests/chapters/explicit/problem.hpp"

namespace mpm::test {

/// Laws that show what a scheme hands to them: one keeps its stress, one writes the velocity gradient there.
struct Keep {
    double rho = 1;
    template <class Point, class Gradient>
    void update(Point&, const Gradient&, double) const {}
};
struct Probe {
    double rho = 1;
    template <class Point, class Gradient>
    void update(Point& p, const Gradient& L, double) const {
        p.sigma = L;
    }
};

void expect_equal(const auto& x, const auto& y) { EXPECT_LT((x - y).norm(), 1e-13); }

template <class Scheme>
class OneStep : public testing::Test {};
TYPED_TEST_SUITE_P(OneStep);

inline const Mat<2> A{{0.3, -0.2}, {0.5, 0.1}}, F0{{1.1, 0.3}, {0.0, 0.9}};  // do not commute
inline const Vec<2> a(0.1, -0.2);

/// Hat functions reproduce v = A X + a inside a body that fills its grid, so L = A there, and no force acts.
TYPED_TEST_P(OneStep, LinearVelocityDeformsExactly) {
    const double dt = 0.01, h = 0.5;
    Problem<2, TypeParam, Probe> s;
    s.add({}, 6, 2, 0, 6, h);
    for (auto& p : s.points()) {
        p.v = A * p.X + a;
        p.F = F0;
        p.V = F0.determinant() * p.V0;
    }
    s.run(1, dt);
    const bool total = std::is_same_v<TypeParam, Tlmpm>;  // its gradient is with respect to X, so Fdot = A
    const Mat<2> F = F0 + dt * (total ? A : Mat<2>(A * F0)), L = total ? Mat<2>(A * F.inverse()) : A;
    int inside = 0;
    for (const auto& p : s.points()) {
        if ((p.X - Vec<2>::Constant(3 * h)).cwiseAbs().maxCoeff() > h) continue;  // two cells from the edge, whose nodes see one side only
        ++inside;
        expect_equal(p.F, F);
        expect_equal(p.sigma, L);
        EXPECT_NEAR(p.V, F.determinant() * p.V0, 1e-15);
        expect_equal(p.v, A * p.X + a);
        expect_equal(p.x, p.X + dt * (A * p.X + a));
    }
    EXPECT_EQ(inside, 16);
}

/// sum over nodes of f x^T = -sum over particles of V sigma (of V0 P on the initial grid), since the functions reproduce linear fields.
TYPED_TEST_P(OneStep, NodalForcesCarryTheStress) {
    Problem<2, TypeParam, Keep> s;
    s.add({}, 3, 2, 1, 5, 0.5);
    Mat<2> expected = Mat<2>::Zero();
    for (auto& p : s.points()) {
        p.F = F0;
        p.V = F0.determinant() * p.V0;
        p.sigma << 2 + p.X[0], 0.5, 0.5, 1 - p.X[1];
        expected -= std::is_same_v<TypeParam, Tlmpm> ? Mat<2>(p.V * p.sigma * F0.inverse().transpose()) : Mat<2>(p.V * p.sigma);
    }
    s.run(1, 1e-3);
    Mat<2> sum = Mat<2>::Zero();
    for (int I = 0; I < s.bodies[0].grid.size(); ++I) sum += s.bodies[0].grid[I].f * s.lattice.position(I).transpose();
    expect_equal(sum, expected);
}

/// A force on every node that grows with time.
struct Falling {
    Vec<2> b{0.5, -9};
    template <class B>
    void load(B& body, double t) const {
        for (auto& node : body.grid) node.f += node.m * b * t;
    }
    template <class G, class Field>
    void fix(G&, Field, double) const {}
};
TYPED_TEST_P(OneStep, BodyForceAcceleratesEveryParticle) {
    const double t = 2, dt = 0.01;
    Problem<2, TypeParam, Keep> s;
    s.add({}, 3, 2, 1, 5, 0.5);
    for (auto& p : s.points()) p.v = a;
    const Falling scene;
    s.scheme.step(s.bodies, Free{}, scene, t, dt);
    const Vec<2> v = a + dt * t * scene.b;
    for (const auto& p : s.points()) {
        expect_equal(p.v, v);
        expect_equal(p.x, p.X + dt * v);
    }
}

/// Every node is held at g(t) = (t, -t).
struct Carried {
    static Vec<2> g(double t) { return {t, -t}; }
    template <class B>
    void load(B&, double) const {}
    template <class G, class Field>
    void fix(G& grid, Field field, double t) const {
        for (auto& node : grid) node.*field = node.m * g(t);
    }
};
TYPED_TEST_P(OneStep, HeldNodesHaveTheirVelocityAtBothEndsOfTheStep) {
    const double t = 2, dt = 0.125;
    Problem<2, TypeParam, Keep> s;
    s.add({}, 3, 2, 1, 5, 0.5);
    s.scheme.step(s.bodies, Free{}, Carried{}, t, dt);
    for (const auto& node : s.bodies[0].grid) {
        if (node.m == 0) continue;
        expect_equal(node.v, Carried::g(t));
        expect_equal(node.v_new, Carried::g(t + dt));
    }
    for (const auto& p : s.points()) {
        expect_equal(p.v, Carried::g(t + dt) - Carried::g(t));
        expect_equal(p.x, p.X + dt * Carried::g(t + dt));
    }
}

/// Nothing of the step before is left on the grid.
TYPED_TEST_P(OneStep, GridStartsAfresh) {
    Problem<2, TypeParam, Keep> s;
    s.add({}, 2, 2, 1, 4, 0.5);
    s.run(3, 0.01);
    double m = 0, total = 0;
    for (const auto& p : s.points()) m += p.m;
    for (const auto& node : s.bodies[0].grid) total += node.m;
    EXPECT_NEAR(total, m, 1e-14);
}

REGISTER_TYPED_TEST_SUITE_P(OneStep, LinearVelocityDeformsExactly, NodalForcesCarryTheStress, BodyForceAcceleratesEveryParticle,
                            HeldNodesHaveTheirVelocityAtBothEndsOfTheStep, GridStartsAfresh);

}  // namespace mpm::test
