// Tractions and pressures on boundary particles.
#include "lab/traction.hpp"

#include <gtest/gtest.h>

#include <array>

#include "chapters/material/hooke.hpp"
#include "tests/chapters/explicit/problem.hpp"

namespace mpm::test {
namespace {

const NeoHookean soft{30, 20, 1};

template <class Body> auto nodal_sum(const Body& body) {
    Vec<Body::D> sum = Vec<Body::D>::Zero();
    for (const auto& node : body.grid) sum += node.f;
    return sum;
}

/// A unit square of 4 x 4 cells and its four loaded sides, a particle's side long each.
template <class Kernel> struct Square {
    Problem<2, Musl, NeoHookean, Kernel> s;
    Traction<2> right, all;
    Square() {
        s.add(soft, 4, 2, 4, 12, 0.25);
        const double side = 0.125, near = 0.1;
        right.add(s.points(), Vec<2>(side, 0), [&](const Vec<2>& X) { return X[0] > 2 - near; });
        all = right;
        all.add(s.points(), Vec<2>(-side, 0), [&](const Vec<2>& X) { return X[0] < 1 + near; });
        all.add(s.points(), Vec<2>(0, side), [&](const Vec<2>& X) { return X[1] > 2 - near; });
        all.add(s.points(), Vec<2>(0, -side), [&](const Vec<2>& X) { return X[1] < 1 + near; });
    }
    void deform(const Mat<2>& F) {
        for (auto& p : s.points()) {
            p.F = F;
            p.x = Vec<2>(1.5, 1.5) + F * (p.X - Vec<2>(1.5, 1.5));
        }
    }
};
Mat<2> sheared() {
    Mat<2> F;
    F << 1.2, 0.3, -0.1, 0.8;
    return F;
}

template <class Kernel> void total_is_area_times_traction() {
    Square<Kernel> q;
    q.deform(sheared());
    auto& body = q.s.bodies[0];
    const Vec<2> t(3, -4);
    q.right.apply(body, Traction<2>::Dead{t});
    EXPECT_LT((nodal_sum(body) - t).norm(), 1e-13);  // the side is 1 long; rounding of 8 particles' sums
    body.grid.reset();
    q.right.apply(body, Traction<2>::Current{t});
    EXPECT_LT((nodal_sum(body) - sheared().col(1).norm() * t).norm(), 1e-13);  // in 2D the side itself: F (0, 1)
    body.grid.reset();
    q.right.apply(body, Traction<2>::Pressure{5});
    EXPECT_LT((nodal_sum(body) + 5 * Vec<2>(0.8, -0.3)).norm(), 1e-13);  // - p times the normal of F (0, 1) = (.3, .8)
}
TEST(Traction, SumsToAreaTimesTraction) {
    total_is_area_times_traction<Hat>();
    total_is_area_times_traction<Ugimp>();
    total_is_area_times_traction<Quadratic>();
    total_is_area_times_traction<Cubic>();
}
TEST(Traction, PressureAllAroundGivesNeitherForceNorMomentum) {
    Square<Cubic> q;
    q.deform(sheared());
    auto& body = q.s.bodies[0];
    q.all.apply(body, Traction<2>::Pressure{5});
    Vec<2> f = Vec<2>::Zero();
    double moment = 0;
    for (int I = 0; I < body.grid.size(); ++I) {
        const Vec<2> x = body.grid.lattice().position(I), &f_I = body.grid[I].f;
        f += f_I;
        moment += x[0] * f_I[1] - x[1] * f_I[0];
    }
    EXPECT_LT(f.norm(), 1e-12);        // rounding of forces of order 5
    EXPECT_LT(std::abs(moment), 1e-11);  // functions reproduce x, and the particles of opposite sides lie opposite
}
struct Loaded {
    const Traction<2>& side;
    Traction<2>::Dead force;
    template <class B> void load(B& body, double) const { side.apply(body, force); }
    template <class G, class Field> void fix(G&, Field, double) const {}
};
/// What the supply leaves open of a free square's momentum and energy at t = .4, in parts of them.
template <class Scheme> std::array<double, 2> open_balance(double dt) {
    Square<Hat> q;
    const Traction<2>::Dead force{Vec<2>(0.7, -0.2)};
    Supply given;
    for (int k = 0; k * dt < 0.4; ++k) {
        Scheme{}.step(q.s.bodies, Free{}, Loaded{q.right, force}, 0, dt);
        given += q.right.supply(q.s.points(), force, dt);
    }
    const Vec<2> impulse(given.impulse[0], given.impulse[1]);
    return {(q.s.momentum() - impulse).norm() / impulse.norm(), measure(q.s.bodies).total() / given.work - 1};
}
TEST(Traction, GivesAFreeBodyItsMomentumAndItsEnergy) {
    const auto coarse = open_balance<Musl>(0.002), fine = open_balance<Musl>(0.001);
    EXPECT_LT(coarse[0], 1e-12);  // rounding
    EXPECT_LT(std::abs(coarse[1]), 0.03);
    EXPECT_NEAR(coarse[1] / fine[1], 2, 0.2);  // kinetic and strain energy are half a step apart: first order
}

/// A bar of length 1 and modulus 1, held at x = 0 and pulled at its other end with .01, damped until it rests.
struct PulledBar {
    Traction<1> end;
    template <class B> void load(B& body, double) const {
        end.apply(body, Traction<1>::Dead{Vec<1>(0.01)});
        for (auto& node : body.grid) node.f -= 3 * node.mv;  // critical for the longest wave, pi/2 c/L
    }
    template <class G, class Field> void fix(G& grid, Field field, double) const { (grid[0].*field)[0] = 0; }
};
/// What its end, x = 1, lacks of the displacement .01, in parts of it.
double lacks(int cells, int ppc) {
    Problem<1, Tlmpm, Hooke> s;
    s.add(Hooke{0.5, 0.25, 1}, cells, ppc, 0, cells, 1.0 / cells);
    s.bodies[0].transfer.alpha = 0.9;  // what nodes do not see does not come to rest with FLIP alone
    PulledBar scene;
    scene.end.particles.push_back({s.points().size() - 1, Vec<1>(1.0), s.points().back().x});
    const double dt = 0.5 / cells;
    for (int k = 0; k * dt < 20; ++k) s.scheme.step(s.bodies, Free{}, scene, k * dt, dt);
    const auto& last = s.points().back();
    const double u_end = last.x[0] - last.X[0] + (last.F(0, 0) - 1) * (1 - last.X[0]);
    return 1 - u_end / 0.01;
}
// The force acts half a particle inside: by the balance of the last node, 1/(2 ppc) of the last cell's strain is missing.
TEST(Traction, ActsHalfAParticleInsideTheEnd) {
    for (const int ppc : {1, 2, 4})
        for (const int cells : {8, 16, 32})
            EXPECT_NEAR(lacks(cells, ppc), 1.0 / (2 * ppc * cells), 1e-8);  // what is left of the motion
}

}  // namespace
}  // namespace mpm::test
