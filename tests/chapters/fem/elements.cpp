// Finite elements by themselves: masses, patch tests, invariants, the agreement of both formulations, the closed forms of a bar.
#include <gtest/gtest.h>

#include <numbers>

#include "chapters/material/hooke.hpp"
#include "tests/chapters/fem/problem.hpp"

namespace mpm::test {
namespace {

template <class Scheme> class Elements : public testing::Test {};
using Both = testing::Types<TotalFem, UpdatedFem>;
struct Names {
    template <class Scheme> static std::string GetName(int) { return Scheme::name; }
};
TYPED_TEST_SUITE(Elements, Both, Names);

template <class Scheme, class Kernel> std::vector<double> masses(int gauss) {
    Mesh<1, Scheme, Kernel> mesh(2, gauss, 0.5, {0, 50, 3});
    mesh.start(Thrown<1>{});
    std::vector<double> m;
    for (const auto& node : mesh.grid()) m.push_back(node.m / (3 * 0.5));
    return m;
}
void expect_near(const std::vector<double>& a, const std::vector<double>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-15);  // sums of a few terms below 1
}
TYPED_TEST(Elements, LumpTheirMassByRowSums) {
    for (const int gauss : {1, 2, 3}) expect_near(masses<TypeParam, Hat>(gauss), {0.5, 1, 0.5});
    for (const int gauss : {2, 3}) expect_near(masses<TypeParam, Lagrange2>(gauss), {1.0 / 6, 4.0 / 6, 2.0 / 6, 4.0 / 6, 1.0 / 6});
}

/// v = A X + a moves every point and deforms every element exactly as the field says, in one step without forces.
TYPED_TEST(Elements, ReproduceALinearMotion) {
    Thrown<2> field;
    field.A << 0.3, -0.2, 0.5, 0.1;
    field.a << 0.1, -0.2;
    Mesh<2, TypeParam> mesh(3, 2, 0.5);
    mesh.start(field);
    for (const auto& p : mesh.points()) EXPECT_LT((p.v - field.A * p.X - field.a).norm(), 1e-15);
    mesh.run(field, 1, 0.1);
    for (const auto& p : mesh.points()) {  // sums of nine terms of order 1
        EXPECT_LT((p.F - identity<2>() - 0.1 * field.A).norm(), 1e-14);
        EXPECT_LT((p.x - p.X - 0.1 * (field.A * p.X + field.a)).norm(), 1e-14);
        EXPECT_NEAR(p.V, p.F.determinant() * p.V0, 1e-15);
    }
}

struct Deformed {
    static constexpr int D = 2;
    Mat<2> F, sigma = Mat<2>::Zero();
};

/// The patch test: one stress everywhere leaves the nodes inside without force, and sum f x^T = -sum V sigma.
TYPED_TEST(Elements, PassThePatchTest) {
    Thrown<2> field;
    field.A << 0.3, -0.2, 0.5, 0.1;
    Mesh<2, TypeParam> mesh(4, 2, 0.25);
    mesh.start(field);
    mesh.run(field, 2, 0.1);  // the forces of the second step are those of a uniform F
    Mat<2> carried = Mat<2>::Zero(), expected = Mat<2>::Zero();
    for (int I = 0; I < mesh.grid().size(); ++I) {
        const Lattice<2>& lattice = mesh.grid().lattice();
        const int i = lattice.along(I, 0), j = lattice.along(I, 1);
        const Vec<2> X = lattice.position(I), f = mesh.grid()[I].f;
        carried += f * (X + 0.1 * field.A * X).transpose();
        if (i > 0 && i < 4 && j > 0 && j < 4) { EXPECT_LT(f.norm(), 1e-13); }  // of stresses of order 10
    }
    Deformed deformed{identity<2>() + 0.1 * field.A};
    soft.update(deformed, deformed.F, 0);
    for (const auto& p : mesh.points()) expected -= p.V0 * deformed.F.determinant() * deformed.sigma;
    EXPECT_LT((carried - expected).norm(), 1e-13);
}

TYPED_TEST(Elements, KeepMomentumAndEnergyOfAFreeSquare) {
    Thrown<2> field;
    field.A << 0.3, -0.2, 0.5, 0.1;
    field.a << 0.1, -0.2;
    field.wave = 0.3;
    Mesh<2, TypeParam> mesh(6, 2, 0.25);
    mesh.start(field);
    const Measures before = measure(mesh.bodies);
    mesh.run(field, 2000, 0.001);
    const Measures after = measure(mesh.bodies);
    for (const std::size_t d : {0, 1}) EXPECT_NEAR(after.momentum[d], before.momentum[d], 1e-12);  // 2000 roundings of order 1e-16
    EXPECT_NEAR(after.total() / before.total(), 1, 5e-3);  // kinetic and strain energy are half a step apart
    EXPECT_GT(after.strain, 0.1 * before.total()) << "hardly anything happened";
}

/// The first node moves with velocity t.
struct Held : Thrown<1> {
    template <class G, class Field> void fix(G& grid, Field field, double t) const { (grid[0].*field)[0] = grid[0].m * t; }
};
TYPED_TEST(Elements, HoldTheirNodes) {
    Held field;
    field.a << 1;
    Mesh<1, TypeParam> mesh(3, 2, 1);
    mesh.start(field);
    EXPECT_EQ(mesh.grid()[0].v[0], 0);
    EXPECT_EQ(mesh.grid()[1].v[0], 1);
    mesh.run(field, 1, 0.125);
    EXPECT_EQ(mesh.grid()[0].v[0], 0.125);
    EXPECT_EQ(mesh.grid()[0].u[0], 0.125 * 0.125);
}

/// With a stress that depends on F alone, the moved mesh and the initial one give the same forces: the same motion to rounding.
template <int D, class Kernel> void expect_same_motion(int cells, int gauss) {
    Thrown<D> field;
    field.A.setConstant(0.2);
    field.wave = 1.5;
    Mesh<D, TotalFem, Kernel> total(cells, gauss, 0.25);
    Mesh<D, UpdatedFem, Kernel> updated(cells, gauss, 0.25);
    total.start(field);
    updated.start(field);
    total.run(field, 1000, 1e-3);
    updated.run(field, 1000, 1e-3);
    double largest = 0;
    for (std::size_t i = 0; i < total.points().size(); ++i) {
        const auto &a = total.points()[i], &b = updated.points()[i];
        EXPECT_LT((a.x - b.x).norm(), 1e-12);
        EXPECT_LT((a.F - b.F).norm(), 1e-11);
        EXPECT_LT((a.sigma - b.sigma).norm(), 1e-9);  // moduli of 30
        largest = std::max(largest, (a.F - identity<D>()).norm());
    }
    EXPECT_GT(largest, 0.1) << "hardly anything happened";
}
TEST(Formulations, AgreeOnALine) { expect_same_motion<1, Hat>(8, 1); }
TEST(Formulations, AgreeOnALineOfQuadraticElements) { expect_same_motion<1, Lagrange2>(8, 2); }
TEST(Formulations, AgreeInThePlane) { expect_same_motion<2, Hat>(4, 2); }
TEST(Formulations, AgreeInThePlaneWithQuadraticElements) { expect_same_motion<2, Lagrange2>(3, 3); }

/// Largest displacement of a rough bar after 200 steps of `fraction` of h/c.
template <class Kernel> double grown(int gauss, double fraction) {
    Thrown<1> field;
    field.wave = 1e-6;
    const Hooke law{0, 50, 1};
    Mesh<1, TotalFem, Kernel, NoTransfer, Hooke> mesh(10, gauss, 1, law);
    mesh.start(field);
    mesh.run(field, 200, fraction / law.wave_speed());
    double largest = 0;
    for (const auto& node : mesh.grid()) largest = std::max(largest, std::abs(node.u[0]));
    return largest;
}
// The highest frequency is 2 c/h for linear elements, nodes moving against their neighbours, and sqrt(24) c/h for quadratic ones, middles
// moving against ends; a leapfrog is stable up to 2 over it, and 1 % above it grows by 1.33 each step. A free bar drifts by at most 200
// steps of 1e-6 h/c.
TEST(ClosedForm, CriticalStepOfLinearElements) {
    EXPECT_LT(grown<Hat>(1, 0.99), 1e-3);
    EXPECT_GT(grown<Hat>(1, 1.01), 1e3);
}
TEST(ClosedForm, CriticalStepOfQuadraticElements) {
    EXPECT_LT(grown<Lagrange2>(2, 0.99 * 2 / std::sqrt(24)), 1e-3);
    EXPECT_GT(grown<Lagrange2>(2, 1.01 * 2 / std::sqrt(24)), 1e3);
}

}  // namespace
}  // namespace mpm::test
