// Review appendix C: CPDI is a mesh of finite elements whose corners' lumped masses and one-point forces go to the grid by its hat
// functions. The elements are written here on their own, with parent coordinates and Jacobians.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "chapters/cpdi/domains.hpp"
#include "chapters/cpdi/q4.hpp"
#include "chapters/cpdi/t3.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/usl.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "lab/boundary.hpp"
#include "lab/fill.hpp"

namespace mpm::test {
namespace {

const Lattice<2> lattice(Vec<2>(-4, -4), Vec<2>(0.5, 0.4), {20, 24});

/// Mass and force of an element's corners: the consistent mass matrix's row sums, and -V sigma grad M at the one point in the middle.
template <std::size_t N> struct Element {
    std::array<double, N> m{};
    std::array<Vec<2>, N> f;
};

Element<3> element(const std::array<Vec<2>, 3>& x, double rho, const Mat<2>& sigma) {
    Mat<2> J;
    J << x[1] - x[0], x[2] - x[0];
    const double area = J.determinant() / 2;
    const std::array<Vec<2>, 3> dM{Vec<2>(-1, -1), Vec<2>(1, 0), Vec<2>(0, 1)};
    Element<3> e;
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) e.m[a] += rho * area / (a == b ? 6 : 12);
        e.f[a] = -area * sigma * (J.inverse().transpose() * dM[a]);
    }
    return e;
}

Element<4> element(const std::array<Vec<2>, 4>& x, double rho, const Mat<2>& sigma) {
    const auto at = [&](double r, double s, auto&& visit) {  // parent square from 0 to 1
        const std::array<double, 4> M{(1 - r) * (1 - s), r * (1 - s), r * s, (1 - r) * s};
        const std::array<Vec<2>, 4> dM{Vec<2>(s - 1, r - 1), Vec<2>(1 - s, -r), Vec<2>(s, r), Vec<2>(-s, 1 - r)};
        Mat<2> J = Mat<2>::Zero();
        for (std::size_t c = 0; c < 4; ++c) J += x[c] * dM[c].transpose();
        visit(M, dM, J);
    };
    Element<4> e;
    const CellRule rule = gauss_points(2);  // exact: M_a M_b det J is of degree 3 in each coordinate
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j)
            at(rule.at[i], rule.at[j], [&](const auto& M, const auto&, const Mat<2>& J) {
                const double dm = rho * rule.part[i] * rule.part[j] * J.determinant();
                for (std::size_t a = 0; a < 4; ++a)
                    for (std::size_t b = 0; b < 4; ++b) e.m[a] += dm * M[a] * M[b];
            });
    at(0.5, 0.5, [&](const auto&, const auto& dM, const Mat<2>& J) {
        for (std::size_t a = 0; a < 4; ++a) e.f[a] = -J.determinant() * sigma * (J.inverse().transpose() * dM[a]);
    });
    return e;
}

/// Convex, counter-clockwise, about a random place, at most three cells long.
template <std::size_t N> std::array<Vec<2>, N> random_domain(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-3, 3), turn(0.1, 0.9);
    const Vec<2> middle(place(random), place(random));
    std::array<Vec<2>, N> x;
    for (std::size_t c = 0; c < N; ++c) {
        const double angle = 2 * M_PI * (static_cast<double>(c) + turn(random)) / N;
        x[c] = middle + 0.5 * Vec<2>(std::cos(angle), std::sin(angle));
    }
    return x;
}

template <class Domain> void expect_finite_elements() {
    constexpr std::size_t N = Domain::corners;
    constexpr double rho = 2.5;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> stress(-1, 1);
    using Shape = Domains<Domain, false>;
    using B = Body<2, Point<2>, mpm::Node<2>, NeoHookean, Shape, Flip>;
    for (int k = 0; k < 300; ++k) {
        const auto x = random_domain<N>(random);
        std::array<int, N> numbers;
        for (std::size_t c = 0; c < N; ++c) numbers[c] = static_cast<int>(c);
        Point<2> p;
        const auto w = Domain::weights(x);
        p.V = p.V0 = w.V, p.m = rho * w.V, p.x = w.centroid;
        p.sigma << stress(random), stress(random), 0, stress(random);
        p.sigma(1, 0) = p.sigma(0, 1);
        const Shape shape(lattice, {x.begin(), x.end()}, {numbers});
        std::vector<B> bodies{B{{{p}, Grid<2, mpm::Node<2>>(lattice), NeoHookean{1, 1, rho}}, shape, Flip{}}};
        Usl{}.step(bodies, Free{}, FreeScene{}, 0, 0);

        const Element<N> e = element(x, rho, p.sigma);
        for (int I = 0; I < lattice.size(); ++I) {
            double m = 0;
            Vec<2> f = Vec<2>::Zero();
            for (std::size_t c = 0; c < N; ++c) {
                const Vec<2> r = (x[c] - lattice.position(I)).cwiseQuotient(lattice.h()).cwiseAbs();
                const double hat = std::max(0.0, 1 - r[0]) * std::max(0.0, 1 - r[1]);
                m += hat * e.m[c], f += hat * e.f[c];
            }
            EXPECT_NEAR(bodies[0].grid[I].m, m, 1e-13);  // masses and forces are of order one
            EXPECT_LT((bodies[0].grid[I].f - f).norm(), 1e-13);
        }
    }
}

TEST(AppendixC, TrianglesAreFiniteElements) { expect_finite_elements<DomainT3>(); }
TEST(AppendixC, QuadrilateralsAreFiniteElements) { expect_finite_elements<DomainQ4>(); }

}  // namespace
}  // namespace mpm::test
