// Weights of the domains (review 3.6): sums, exactness for linear fields, quadrature, and the finite element construction of appendix C.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "chapters/cpdi/l2.hpp"
#include "chapters/cpdi/polygon.hpp"
#include "chapters/cpdi/q4.hpp"
#include "chapters/cpdi/r4.hpp"
#include "chapters/cpdi/t3.hpp"
#include "lab/fill.hpp"

namespace mpm::test {
namespace {

std::mt19937 random_numbers(7);
double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_numbers); }
Vec<2> place() { return {uniform(-2, 3), uniform(-3, 2)}; }

std::array<Vec<2>, 3> triangle() {
    std::array<Vec<2>, 3> x;
    do x = {place(), place(), place()};
    while (cross(x[1] - x[0], x[2] - x[0]) < 0.05);
    return x;
}
/// Convex, counter-clockwise: corners in the order of their angles about a point.
std::vector<Vec<2>> convex(int n, double flatness = 1) {
    std::vector<double> angles(static_cast<std::size_t>(n));
    for (int c = 0; c < n; ++c) angles[static_cast<std::size_t>(c)] = 2 * M_PI * (c + uniform(0.1, 0.9)) / n;
    const Vec<2> middle = place();
    std::vector<Vec<2>> x;
    for (const double angle : angles) x.push_back(middle + Vec<2>(std::cos(angle), flatness * std::sin(angle)));
    return x;
}
std::array<Vec<2>, 4> quadrilateral(double flatness = 1) {
    const std::vector<Vec<2>> x = convex(4, flatness);
    return {x[0], x[1], x[2], x[3]};
}
std::array<Vec<2>, 4> parallelogram() {
    Vec<2> r1, r2;
    do r1 = place(), r2 = place();
    while (cross(r1, r2) < 0.05);
    const Vec<2> x = place();
    return {x - r1 - r2, x + r1 - r2, x + r1 + r2, x - r1 + r2};
}

/// sum w_f = 1, sum w_g = 0, centroid = sum w_f x_c, and the gradient of x is the identity: sum w_g x_c^T. Rounding is relative to the size of the
/// gradient weights, which grow as the domain flattens.
template <int D, std::size_t N> void expect_linear(const DomainWeights<D, N>& w, const std::array<Vec<D>, N>& x) {
    double sum = 0, size = 0;
    Vec<D> g = Vec<D>::Zero(), centre = Vec<D>::Zero();
    Mat<D> gradient = Mat<D>::Zero();
    for (std::size_t c = 0; c < N; ++c) {
        sum += w.f[c], g += w.g[c], centre += w.f[c] * x[c], gradient += x[c] * w.g[c].transpose();
        size += w.g[c].norm();
    }
    EXPECT_NEAR(sum, 1, 1e-13);
    EXPECT_LT(g.norm(), 1e-15 * (1 + size));
    EXPECT_LT((centre - w.centroid).norm(), 1e-12);
    EXPECT_LT((gradient - identity<D>()).norm(), 1e-14 * (1 + size));
}

TEST(DomainWeights, SumToOneAndReproduceLinearFields) {
    for (int i = 0; i < 1000; ++i) {
        const double flatness = std::pow(10.0, -6.0 * (i % 3) / 2);  // down to a millionth as high as long
        const auto t = triangle();
        expect_linear(DomainT3::weights(t), t);
        const auto q = quadrilateral(flatness);
        expect_linear(DomainQ4::weights(q), q);
        const auto r = parallelogram();
        expect_linear(DomainR4::weights(r), r);
        const std::array<Vec<1>, 2> l{Vec<1>(uniform(-1, 0)), Vec<1>(uniform(0.01, 1))};
        expect_linear(DomainL2::weights(l), l);
    }
}
// A parallelogram is a quadrilateral, clockwise ones included: there V is negative and all else the same.
TEST(DomainWeights, OfParallelogramsAgree) {
    for (int i = 0; i < 100; ++i) {
        auto x = parallelogram();
        if (i % 2) std::swap(x[1], x[3]);
        const auto r = DomainR4::weights(x), q = DomainQ4::weights(x);
        EXPECT_NEAR(r.V, q.V, 1e-12);
        EXPECT_EQ(r.V < 0, i % 2 == 1);
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_NEAR(r.f[c], q.f[c], 1e-13);
            EXPECT_LT((r.g[c] - q.g[c]).norm(), 1e-13 * (1 + r.g[c].norm()));
        }
    }
}

// (3.30), (3.31) by quadrature: the integrands are polynomials of degree 3 and 1 in each parent coordinate, 2 x 2 Gauss points are exact.
TEST(DomainWeights, OfQuadrilateralsAreTheIntegralsOfTheirFunctions) {
    const CellRule rule = gauss_points(2);
    for (int i = 0; i < 200; ++i) {
        const auto x = quadrilateral();
        std::array<double, 4> f{};
        std::array<Vec<2>, 4> g;
        g.fill(Vec<2>::Zero());
        double V = 0;
        for (std::size_t a = 0; a < 2; ++a)
            for (std::size_t b = 0; b < 2; ++b) {
                const double r = rule.at[a], s = rule.at[b];
                const std::array<double, 4> M{(1 - r) * (1 - s), r * (1 - s), r * s, (1 - r) * s};
                const std::array<Vec<2>, 4> dM{Vec<2>(s - 1, r - 1), Vec<2>(1 - s, -r), Vec<2>(s, r), Vec<2>(-s, 1 - r)};
                Mat<2> J = Mat<2>::Zero();
                for (std::size_t c = 0; c < 4; ++c) J += x[c] * dM[c].transpose();
                const double dV = rule.part[a] * rule.part[b] * J.determinant();
                V += dV;
                for (std::size_t c = 0; c < 4; ++c) f[c] += M[c] * dV, g[c] += J.inverse().transpose() * dM[c] * dV;
            }
        const auto w = DomainQ4::weights(x);
        EXPECT_NEAR(w.V, V, 1e-13);
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_NEAR(w.f[c], f[c] / V, 1e-13);
            EXPECT_LT((w.g[c] - g[c] / V).norm(), 1e-13 * (1 + g[c].norm() / V));
        }
    }
}

struct PolygonWeights {
    std::vector<double> f;
    std::vector<Vec<2>> g;
    DomainPolygon::Size size;
    explicit PolygonWeights(const std::vector<Vec<2>>& x) : f(x.size()), g(x.size()) {
        size = DomainPolygon::weights(x.size(), [&](std::size_t c) { return x[c]; }, [&](std::size_t c, double a, const Vec<2>& b) { f[c] = a, g[c] = b; });
    }
};

// Triangles about the centroid, each with its linear functions: a third of its area for each of its corners, a constant gradient.
TEST(DomainWeights, OfPolygonsAreTheSumsOverTheirTriangles) {
    for (int n = 4; n <= 10; ++n)
        for (int i = 0; i < 50; ++i) {
            const std::vector<Vec<2>> x = convex(n);
            const auto count = x.size();
            const PolygonWeights w(x);
            std::vector<double> f(count);
            std::vector<Vec<2>> g(count, Vec<2>::Zero());
            double V = 0, inner = 0;
            Vec<2> inner_g = Vec<2>::Zero();
            for (std::size_t c = 0; c < count; ++c) {
                const std::array<Vec<2>, 3> t{x[c], x[(c + 1) % count], w.size.centroid};
                const auto part = DomainT3::weights(t);
                V += part.V;
                f[c] += part.V / 3, f[(c + 1) % count] += part.V / 3, inner += part.V / 3;
                g[c] += part.V * part.g[0], g[(c + 1) % count] += part.V * part.g[1], inner_g += part.V * part.g[2];
            }
            EXPECT_NEAR(w.size.V, V, 1e-13);
            EXPECT_NEAR(inner / V, DomainPolygon::inner_weight(count), 1e-14);
            EXPECT_LT(inner_g.norm() / V, 1e-13);
            double sum = DomainPolygon::inner_weight(count);
            for (std::size_t c = 0; c < count; ++c) {
                sum += w.f[c];
                EXPECT_NEAR(w.f[c], f[c] / V, 1e-13);
                EXPECT_LT((w.g[c] - g[c] / V).norm(), 1e-12);
            }
            EXPECT_NEAR(sum, 1, 1e-13);
        }
}
TEST(DomainWeights, OfAPolygonWithThreeCornersAreThoseOfTheTriangle) {
    for (int i = 0; i < 100; ++i) {
        const auto t = triangle();
        const auto exact = DomainT3::weights(t);
        const PolygonWeights w({t[0], t[1], t[2]});
        EXPECT_EQ(DomainPolygon::inner_weight(3), 0);
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(w.f[c], exact.f[c], 1e-14);
            EXPECT_LT((w.g[c] - exact.g[c]).norm(), 1e-13 * (1 + exact.g[c].norm()));
        }
    }
}

}  // namespace
}  // namespace mpm::test
