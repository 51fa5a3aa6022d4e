// Implicit MPM and finite elements in one system.
#include <gtest/gtest.h>

#include "chapters/scenes/bouncing_on_fem.hpp"
#include "tests/chapters/coupling/stack.hpp"

namespace mpm {
namespace {

TEST(ElasticExtension, OfATranslationIsATranslation) {
    const Rectilinear<2> grid({even_lines(0, 3, 3), Lines{0, 0.8, 2, 3}}, sharing_of<QuadraticElement>());
    std::vector<char> given(static_cast<std::size_t>(grid.size()), 0);
    std::fill_n(given.begin(), 3 * grid.nodes(0), 1);
    ElasticExtension<QuadraticElement, 2> extension;
    extension.use(grid, {3, 4, 5, 6, 7, 8}, given, std::vector<char>(given.size() * 2, 0));
    std::vector<Vec<2>> u(given.size(), Vec<2>::Zero());
    for (std::size_t I = 0; I < u.size(); ++I)
        if (given[I]) u[I] = Vec<2>(0.3, -0.2);
    ASSERT_TRUE(extension.extend(grid, u));
    for (const Vec<2>& at : u) EXPECT_LT((at - Vec<2>(0.3, -0.2)).norm(), 1e-13);
}
TEST(BouncingOnFem, ThinRowsTakeThePlaceOfTheLowest) {
    BouncingOnFem scene;
    const Lines whole = scene.lines(32)[1];
    const double layer = scene.layer(32);
    scene.thin = 4;
    Lines thin = scene.lines(32)[1];
    const auto plate = static_cast<std::size_t>(scene.plate_rows(32));
    EXPECT_DOUBLE_EQ(scene.layer(32), layer / 4);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(thin[plate + i], static_cast<double>(i) * layer / 4, 1e-15);
    thin.erase(thin.begin() + static_cast<long>(plate) + 1, thin.begin() + static_cast<long>(plate) + 4);
    EXPECT_EQ(thin, whole);
}
TEST(ElasticExtension, InOneDimensionFallsOffLinearly) {
    const Rectilinear<1> grid({even_lines(0, 5, 5)});
    ElasticExtension<LinearElement, 1> extension;
    extension.use(grid, {1, 2, 3, 4}, {1, 1, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 1});
    std::vector<Vec<1>> u(6, Vec<1>(0));
    u[1][0] = 0.4;
    ASSERT_TRUE(extension.extend(grid, u));
    for (std::size_t I = 1; I < 6; ++I) EXPECT_NEAR(u[I][0], 0.1 * static_cast<double>(5 - I), 1e-15);
}

/// Particles are where their weights say, and gradients are those of the deformed grid: that of x is 1.
TEST(FemBody, FindsParticlesInTheDeformedBackground) {
    Stack stack;
    auto method = stack.method(Stack::settings(Carry::particle));
    const auto& plate = method.attached();
    for (std::size_t i = 0; i < stack.body.points.size(); ++i) {
        const auto& p = stack.body.points[i];
        const int e = plate.element(stack.grid, i, p);
        const auto w = plate.weights(stack.grid, e, i, p);
        Vec<2> x = Vec<2>::Zero();
        Mat<2> gradient = Mat<2>::Zero();
        for (int k = 0; k < 9; ++k) {
            const int I = stack.grid.node(e, k);
            const Vec<2> at = stack.grid.position(I) + plate.node(I).u;
            x += w.phi[static_cast<std::size_t>(k)] * at;
            gradient += at * w.grad[static_cast<std::size_t>(k)].transpose();
        }
        EXPECT_LT((x - p.x).norm(), 2e-14);  // what find is content with, of a grid of size 4
        EXPECT_LT((gradient - identity<2>()).norm(), 1e-13);
    }
    EXPECT_EQ(plate.inside(), 0);
}
TEST(FemBody, NamesAParticleThatStartsInside) {
    Stack stack;
    stack.body.points[0].x = Vec<2>(1.5, 0.4);
    EXPECT_EQ(stack.method(Stack::settings(Carry::particle)).attached().trouble().cause, "particle-inside-body");
}

TEST(Coupling, TangentIsTheDerivativeOfTheResidual) {
    Stack stack;
    auto method = stack.method(Stack::settings(Carry::particle));
    method.step(0, 0.05);
    const Equations now = method.equations(0.05, 0.05);
    const auto n = static_cast<std::size_t>(method.system().unknowns());
    std::vector<double> u(n), r(n), plus(n), minus(n);
    for (std::size_t i = 0; i < n; ++i) u[i] = 0.01 * std::sin(static_cast<double>(3 * i + 1));
    double terms = 0, rounding = 0, off = 0, size = 0;
    ASSERT_TRUE(now.residual(u, r, terms, rounding));
    method.assemble_tangent(u);
    for (std::size_t j = 0; j < n; ++j) {
        constexpr double h = 1e-6;
        auto moved = u;
        moved[j] += h;
        now.residual(moved, plus, terms, rounding);
        moved[j] -= 2 * h;
        now.residual(moved, minus, terms, rounding);
        for (std::size_t i = 0; i < n; ++i) {
            const double K = method.system().entry(static_cast<int>(i), static_cast<int>(j));
            const double by_differences = (plus[i] - minus[i]) / (2 * h);
            off += (K - by_differences) * (K - by_differences), size += K * K;
        }
    }
    EXPECT_LT(std::sqrt(off / size), 1e-8);  // central differences: h^2 and eps/h
}

/// Nothing is held: whatever one body loses the other gains.
TEST(Coupling, MomentumOfAFreeSystemIsKept) {
    for (const Carry carry : {Carry::particle, Carry::midpoint, Carry::conserving}) {
        Stack stack;
        auto method = stack.method(Stack::settings(carry));
        const Measures before = stack.measure(method);
        for (int n = 0; n < 6; ++n) method.step(0.05 * n, 0.05);
        ASSERT_FALSE(method.trouble()) << method.trouble().reason;
        const Measures after = stack.measure(method);
        for (std::size_t d = 0; d < 2; ++d) EXPECT_NEAR(after.momentum[d], before.momentum[d], 1e-12 * before.momentum_in_play);
    }
}
/// At each shared node, and as what each body gets: with the midpoint rule the change of its momentum is dt times the force.
TEST(Coupling, ForcesAcrossTheInterfaceBalance) {
    Stack stack;
    auto method = stack.method(Stack::settings(Carry::midpoint));
    double pressed = 0;
    for (int n = 0; n < 6; ++n) {
        Measures particles, plate, later, plate_later;
        add_measures(stack.body, particles), method.attached().measure(plate);
        method.step(0.05 * n, 0.05);
        add_measures(stack.body, later), method.attached().measure(plate_later);
        const auto& exchange = method.attached().exchange();
        pressed = std::max(pressed, exchange.on_particles[1]);
        for (const std::size_t d : {std::size_t{0}, std::size_t{1}}) {
            const auto axis = static_cast<Eigen::Index>(d);
            EXPECT_NEAR(exchange.on_particles[axis], -exchange.on_body[axis], 1e-10 * exchange.on_body.norm() + 1e-13);
            EXPECT_NEAR(later.momentum[d] - particles.momentum[d], 0.05 * exchange.on_particles[axis], 1e-11);  // Newton's tolerance
            EXPECT_NEAR(plate_later.momentum[d] - plate.momentum[d], 0.05 * exchange.on_body[axis], 1e-11);
        }
    }
    EXPECT_GT(pressed, 1);
    EXPECT_LT(method.attached().exchange().imbalance(), 1e-10);
}
TEST(Coupling, ConservingStepsKeepTheEnergyOfBothBodies) {
    Stack stack;
    auto method = stack.method(Stack::settings(Carry::conserving));
    const double before = stack.measure(method).total();
    for (int n = 0; n < 6; ++n) method.step(0.05 * n, 0.05);
    EXPECT_NEAR(stack.measure(method).total() / before, 1, 1e-11);  // Newton's tolerance in each step
}
TEST(Coupling, NoParticleEntersTheBody) {
    Stack stack;
    stack.scene.held_floor = true;
    auto method = stack.method(Stack::settings(Carry::particle));
    for (auto& p : stack.body.points) p.v[1] -= 0.5;
    for (int n = 0; n < 15; ++n) method.step(0.02 * n, 0.02);
    EXPECT_FALSE(method.trouble()) << method.trouble().reason;
    EXPECT_EQ(method.attached().inside(), 0);
}
TEST(Coupling, NamesAnElementThatWouldBeTurnedInsideOut) {
    Stack stack;
    stack.scene.held_floor = true;
    stack.scene.plate = {1e-3, 1e-3, 1e-3};
    stack.body.law = {3e4, 2e4, 1};
    ImplicitSettings s = Stack::settings(Carry::midpoint);
    s.cuts = 3;
    auto method = stack.method(s);
    for (int n = 0; n < 40 && !method.trouble(); ++n) method.step(0.05 * n, 0.05);
    EXPECT_EQ(method.trouble().cause, "inverted-element") << method.trouble().reason;
    for (const auto& p : method.attached().gauss().points) EXPECT_GT(p.F.determinant(), 0);
}

}  // namespace
}  // namespace mpm
