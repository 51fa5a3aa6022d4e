// One particle's residual and its tangents.
#include "chapters/implicit/residual.hpp"

#include <gtest/gtest.h>

#include "chapters/implicit/receding.hpp"

namespace mpm {
namespace {

constexpr int D = 2, N = 9;
using Vector = ElementVector<double, D, N>;
using Matrix = ElementMatrix<D, N>;

const NeoHookean law{3.7, 1.3, 1.1};
const Rectilinear<D> grid({Lines{0, 0.5, 1.4}, Lines{0, 0.8, 1.1}}, sharing_of<QuadraticElement>());

ImplicitPoint<D> particle(const Vec<D>& x) {
    ImplicitPoint<D> p;
    p.x = x;
    p.m = 0.2, p.V0 = 0.2 / law.rho;
    p.v << 0.3, 0.2;
    p.a << -0.7, 1.9;
    p.F << 1.1, 0.2, -0.1, 0.93;
    return p;
}
struct OneParticle {
    ImplicitPoint<D> p = particle({0.37, 0.29});
    ElementWeights<D, N> w = element_weights<QuadraticElement, D>(grid, 0, p.x);
    StepOf<D> step{{0.3, 0.5, 1}, 0.1, Vec<D>(0.4, -9.81)};
    Vector u;
    OneParticle() {
        for (int i = 0; i < N * D; ++i) u[i] = 0.02 * std::sin(3.0 * i + 1);
    }
    Vector residual(const Vector& at) const {
        Vector r = Vector::Zero();
        EXPECT_TRUE((add_residual<double, D, N>(p, law, w, at, step, r)));
        return r;
    }
    Matrix by_hand() const {
        Matrix K = Matrix::Zero();
        add_tangent<D, N>(p, law, w, u, step, K);
        return K;
    }
    Matrix automatic() const {
        Matrix K = Matrix::Zero();
        add_ad_tangent<D, N>(p, law, w, u, step, K);
        return K;
    }
    Matrix by_differences() const {
        const double h = 1e-5;
        Matrix K;
        for (int i = 0; i < N * D; ++i) {
            Vector more = u, less = u;
            more[i] += h, less[i] -= h;
            K.col(i) = (residual(more) - residual(less)) / (2 * h);
        }
        return K;
    }
};
double difference(const Matrix& A, const Matrix& B) { return (A - B).norm() / B.norm(); }

TEST(Tangent, ByHandAndAutomaticAreEqual) {
    OneParticle one;
    EXPECT_LT(difference(one.automatic(), one.by_hand()), 1e-12);
}
TEST(Tangent, IsTheDerivativeOfTheResidual) {
    OneParticle one;
    EXPECT_LT(difference(one.by_hand(), one.by_differences()), 1e-8);  // central differences: h^2 and eps/h
}
TEST(Tangent, HalfwayThroughTheStep) {
    OneParticle one;
    one.step.newmark = Newmark::midpoint();
    EXPECT_LT(difference(one.automatic(), one.by_hand()), 1e-12);
    EXPECT_LT(difference(one.by_hand(), one.by_differences()), 1e-8);
}
TEST(Tangent, WithTheRecedingContact) {
    OneParticle one;
    RecedingContact{0.5, 1}.correct<QuadraticElement>(grid, 0, one.p, one.w);
    EXPECT_LT(difference(one.automatic(), one.by_hand()), 1e-12);
    EXPECT_LT(difference(one.by_hand(), one.by_differences()), 1e-8);
    EXPECT_GT((one.by_hand() - one.by_hand().transpose()).norm(), 1e-3);
}
TEST(Tangent, OfTheConservingStress) {
    OneParticle one;
    one.step.newmark = Newmark::midpoint();
    one.step.conserving = true;
    EXPECT_LT(difference(one.automatic(), one.by_differences()), 1e-8);
}
TEST(Tangent, IsSymmetricWithoutContact) {
    OneParticle one;
    EXPECT_LT(difference(one.by_hand(), one.by_hand().transpose()), 1e-14);
}

/// Nodes moved by x -> c + R x, and no masses: what is left is the force of the stress.
Vector rigid_motion(const Mat<D>& R, const Vec<D>& c) {
    Vector u;
    for (int k = 0; k < N; ++k) {
        const Vec<D> x = grid.position(grid.node(0, k));
        u.segment<D>(k * D) = c + R * x - x;
    }
    return u;
}
const Mat<D> quarter = (Mat<D>() << 0.6, -0.8, 0.8, 0.6).finished();

TEST(Residual, RigidMotionsOfAStressFreeParticleGiveNone) {
    OneParticle one;
    one.p.m = 0;
    one.p.F = identity<D>();
    EXPECT_LT(one.residual(rigid_motion(identity<D>(), {3, 4})).norm(), 1e-13);  // rounding of displacements near 4, times stiffness
    EXPECT_LT(one.residual(rigid_motion(quarter, {0.1, 4})).norm(), 1e-13);
}
TEST(Residual, TurnsWithAStressedParticle) {
    OneParticle one;
    one.p.m = 0;
    const Vector still = one.residual(Vector::Zero()), turned = one.residual(rigid_motion(quarter, {0.1, 0.2}));
    for (int k = 0; k < N; ++k) EXPECT_LT((turned.segment<D>(k * D) - quarter * still.segment<D>(k * D)).norm(), 1e-14);
}
TEST(Residual, ConservingStressDoesTheWorkOfTheStoredEnergy) {
    OneParticle one;
    one.p.m = 0;
    one.step.conserving = true;
    ImplicitPoint<D> after = one.p;
    Mat<D> f = identity<D>();
    for (int k = 0; k < N; ++k) f += one.u.segment<D>(k * D) * one.w.grad[static_cast<std::size_t>(k)].transpose();
    after.F = f * one.p.F;
    const double change = law.energy(after) - law.energy(one.p);
    EXPECT_GT(std::abs(change), 1e-4);
    EXPECT_NEAR(one.residual(one.u).dot(one.u), change, 1e-14);  // rounding of energies near 0.1
}
TEST(Residual, RefusesAnElementTurnedInsideOut) {
    OneParticle one;
    Vector r = Vector::Zero();
    const Vector mirrored = rigid_motion((Mat<D>() << 1, 0, 0, -1).finished(), {0, 0});
    EXPECT_FALSE((add_residual<double, D, N>(one.p, law, one.w, mirrored, one.step, r)));
}
TEST(RecedingContact, NormalStrainOnTheFaceVanishes) {
    OneParticle one;
    one.p.x = Vec<D>(0.37, 0);
    one.w = element_weights<QuadraticElement, D>(grid, 0, one.p.x);
    RecedingContact{1, 1}.correct<QuadraticElement>(grid, 0, one.p, one.w);
    Mat<D> H = Mat<D>::Zero();
    for (int k = 0; k < N; ++k) H += one.u.segment<D>(k * D) * one.w.trial[static_cast<std::size_t>(k)].transpose();
    EXPECT_LT(H.col(1).norm(), 1e-14);
}
TEST(RecedingContact, LeavesParticlesThatApproach) {
    OneParticle one;
    one.p.v[1] = -0.1;
    auto corrected = one.w;
    RecedingContact{1, 1}.correct<QuadraticElement>(grid, 0, one.p, corrected);
    for (std::size_t k = 0; k < N; ++k) EXPECT_EQ(corrected.trial[k], one.w.grad[k]);
}

template <class Element> void partition_of_unity() {
    const Rectilinear<D> even({even_lines(0, 3, 3), even_lines(0, 6, 3)}, sharing_of<Element>());
    for (const double s : {0.0, 1e-15, 0.3, 0.5, 1.0}) {
        const Vec<D> x(1 + s, 2.2);
        const auto w = element_weights<Element, D>(even, 4, x);
        double one = 0;
        Vec<D> zero = Vec<D>::Zero(), place = zero;
        Mat<D> unit = Mat<D>::Zero();
        for (std::size_t k = 0; k < w.phi.size(); ++k) {
            const Vec<D> node = even.position(even.node(4, static_cast<int>(k)));
            one += w.phi[k], zero += w.grad[k], place += w.phi[k] * node, unit += node * w.grad[k].transpose();
        }
        EXPECT_NEAR(one, 1, 1e-15);
        EXPECT_LT(zero.norm(), 1e-14);
        EXPECT_LT((place - x).norm(), 1e-14);  // linear fields are reproduced
        EXPECT_LT((unit - identity<D>()).norm(), 1e-14);
    }
}
TEST(Elements, ReproduceLinearFields) {
    partition_of_unity<LinearElement>();
    partition_of_unity<QuadraticElement>();
    partition_of_unity<QuadraticSpline>();
    partition_of_unity<CubicSpline>();
}

}  // namespace
}  // namespace mpm
