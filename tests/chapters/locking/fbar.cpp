// F-bar (Algorithm 7): what it leaves alone, what it averages, and with every scheme.
#include "chapters/locking/fbar.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "chapters/material/hooke.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "chapters/scenes/pressure_noise.hpp"
#include "tests/chapters/explicit/problem.hpp"
#include "tests/chapters/material/point.hpp"

namespace mpm::test {
namespace {

template <class Law> Law soft() {
    Law law;
    law.lambda = 100, law.mu = 1, law.rho = 1;
    return law;
}

/// A square of 3 x 3 cells that something has bent, with a grid about it.
template <class Scheme, class Law> Problem<2, Scheme, Law> bent(FbarCells cells) {
    Problem<2, Scheme, Law> problem;
    Law law = soft<Law>();
    law.cells = cells;
    problem.add(law, 3, 2, 2, 7, 1.0);
    for (auto& p : problem.points()) p.v = 0.2 * Vec<2>(std::sin(p.X[1]), std::cos(1.3 * p.X[0]));
    return problem;
}

// The same stretch everywhere is its own mean.
TEST(Fbar, LeavesEvenStretchAlone) {
    Problem<2, Musl, Fbar<NeoHookean>> problem;
    problem.add(soft<Fbar<NeoHookean>>(), 2, 2, 1, 4, 1.0);
    Mat<2> F;
    F << 1.1, 0.2, -0.1, 0.95;
    for (auto& p : problem.points()) p.F = F;
    update_together(problem.bodies[0]);
    auto plain = unit_point<2, NeoHookean>();
    plain.F = F;
    soft<NeoHookean>().update(plain, Mat<2>::Zero().eval(), 0);
    for (const auto& p : problem.points()) {
        EXPECT_LT((p.sigma - plain.sigma).norm(), 1e-13 * plain.sigma.norm());
        EXPECT_NEAR(p.F33, 1, 1e-15);
        EXPECT_EQ(p.F, F);
    }
}

// The mean of J with the weights V0; det of F-bar with the stretch across is J0, in the plane and on the line.
template <int D> void takes_the_mean() {
    Problem<D, Musl, Fbar<NeoHookean>> problem;
    problem.add(soft<Fbar<NeoHookean>>(), 1, 2, 1, 3, 1.0);
    double V0 = 0, V = 0, k = 0;
    for (auto& p : problem.points()) {
        p.V0 *= 1 + 0.1 * k;
        p.F = (1 + 0.02 * k++) * identity<D>();
        V0 += p.V0, V += p.V0 * p.F.determinant();
    }
    update_together(problem.bodies[0]);
    for (auto p : problem.points()) {
        EXPECT_NEAR(problem.bodies[0].law.values(p)[0], V / V0, 1e-14);
        p.F *= p.F33;
        EXPECT_NEAR(volume_ratio(p), V / V0, 1e-14);
    }
}
TEST(Fbar, TakesTheMeanOfTheCell) {
    takes_the_mean<1>();
    takes_the_mean<2>();
}

// Stress and stored energy with a stretch across agree: dW = J sigma : dF F^-1 + J sigma33 dF33/F33.
template <class Law> void energy_belongs_to_stress() {
    const Law law = soft<Law>();
    auto p = unit_point<2, Fbar<Law>>();
    p.F << 1.1, 0.2, -0.15, 0.9;
    p.F33 = 1.05;
    law.update(p, NoVelocityGradient{}, 0);
    const auto W = [&](const Mat<2>& dF, double d33) {
        auto q = p;
        q.F += dF, q.F33 += d33;
        return law.energy(q);
    };
    const double d = 1e-5, J = volume_ratio(p);  // central differences: 1e-10 of third derivatives up to 1e3
    for (const int i : {0, 1})
        for (const int j : {0, 1}) {
            Mat<2> dF = Mat<2>::Zero();
            dF(i, j) = d;
            EXPECT_NEAR((W(dF, 0) - W(-dF, 0)) / (2 * d), J * (p.sigma * p.F.inverse().transpose())(i, j), 1e-6);
        }
    EXPECT_NEAR((W(Mat<2>::Zero(), d) - W(Mat<2>::Zero(), -d)) / (2 * d), J * law.sigma_zz(p) / p.F33, 1e-6);
}
TEST(Fbar, LawsKnowTheStretchAcross) {
    energy_belongs_to_stress<NeoHookean>();
    energy_belongs_to_stress<Hooke>();
}

// The pressure that grows with lambda is one for each cell, with every scheme; momentum stays.
template <class Scheme> void one_pressure_in_a_cell(FbarCells cells) {
    auto problem = bent<Scheme, Fbar<NeoHookean>>(cells);
    const Vec<2> before = problem.momentum();
    problem.run(20, 0.01);
    const bool start = cells == FbarCells::moving || Problem<2, Scheme, Fbar<NeoHookean>>::total;
    const auto noise = pressure_noise(
        problem.points(), 1.0, 0, 10, [&](const auto& p) { return start ? p.X : p.x; },
        [](const auto& p) { return volumetric_pressure(p, 100); });
    EXPECT_LT(noise.within, 1e-6) << Scheme::name;  // sqrt of rounding: a variance is the difference of squares
    EXPECT_GT(noise.between, 1e-3) << Scheme::name;
    EXPECT_LT((problem.momentum() - before).norm(), 1e-13) << Scheme::name;
}
TEST(Fbar, GivesEachCellOnePressure) {
    one_pressure_in_a_cell<Musl>(FbarCells::grid);
    one_pressure_in_a_cell<Musl>(FbarCells::moving);
    one_pressure_in_a_cell<Usl>(FbarCells::grid);
    one_pressure_in_a_cell<Tlmpm>(FbarCells::grid);
}

// Without cells each scheme moves as with the plain law, USF too, whose forces then take a sweep of their own.
template <class Scheme> void moves_as_without() {
    auto with = bent<Scheme, Fbar<NeoHookean>>(FbarCells::none);
    Problem<2, Scheme, NeoHookean> without;
    without.add(soft<NeoHookean>(), 3, 2, 2, 7, 1.0);
    for (std::size_t i = 0; i < with.points().size(); ++i) without.points()[i].v = with.points()[i].v;
    with.run(20, 0.01);
    without.run(20, 0.01);
    for (std::size_t i = 0; i < with.points().size(); ++i)
        EXPECT_LT((with.points()[i].x - without.points()[i].x).norm(), 1e-14) << Scheme::name;
}
TEST(Fbar, WithoutCellsIsThePlainLaw) {
    moves_as_without<Musl>();
    moves_as_without<Usf>();
    moves_as_without<Tlmpm>();
}

// A particle that has left the grid keeps its own volume; the next step names it.
TEST(Fbar, OutlivesAParticleOutsideTheGrid) {
    auto problem = bent<Musl, Fbar<NeoHookean>>(FbarCells::grid);
    problem.points()[0].x[0] = -5;
    problem.points()[1].x[1] = std::nan("");
    update_together(problem.bodies[0]);
    EXPECT_EQ(problem.points()[0].F33, 1);
    EXPECT_THROW(problem.run(1, 0.01), OutsideGrid);
}

}  // namespace
}  // namespace mpm::test
