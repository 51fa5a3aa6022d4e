// The TLMPM with its particles at the Gauss points against total-Lagrangian finite elements (review 2.6: they differ in the transfer
// alone).
#include <gtest/gtest.h>

#include "chapters/mms/segment.hpp"
#include "tests/chapters/fem/problem.hpp"

namespace mpm::test {
namespace {

/// Keeps the nodal velocities from step to step: nothing goes to the particles and back.
struct KeepNodes {
    static constexpr const char* name = "keep-nodes";
    template <class Point> using PointOf = Point;
    template <class Base> struct NodeOf : Base {
        Vec<Base::D> kept = Vec<Base::D>::Zero();  // velocity after the last step
        void reset() {
            const Vec<Base::D> stays = kept;
            *this = NodeOf();
            kept = stays;
        }
    };
    template <class Point, class Node> const auto& velocity(const Point&, const Node& node) const { return node.kept; }
    template <class Body, class Fix> void nodal_velocities(Body& body, Fix&&) const {
        for (auto& node : body.grid) node.kept = node.v_new = mpm::velocity(node.mv_new, node.m);
    }
    template <class Body, class Fix> void mapped_velocities(Body&, Fix&&) const {}  // not with the flavour "usl"
    template <class Point, class Weights> void update_velocity(Point& p, const Weights& weights) const {
        p.v.setZero();
        for (const auto& [node, phi, grad] : weights) p.v += phi * node.v_new;
    }
    template <class Point, class Velocity> const Velocity& moving(const Point&, const Velocity& v) const { return v; }
};

/// Masses and forces of one step from the same random deformation.
template <int D, class Kernel> void expect_same_forces(int cells, int gauss) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Mesh<D, Tlmpm, Kernel> particles(cells, gauss, 0.3);
        Mesh<D, TotalFem, Kernel> elements(cells, gauss, 0.3);
        elements.start(Thrown<D>{});
        deform(particles, seed);
        deform(elements, seed);
        particles.run(Thrown<D>{}, 1, 1e-3);
        elements.run(Thrown<D>{}, 1, 1e-3);
        double largest = 0;
        for (int I = 0; I < elements.grid().size(); ++I) {
            const auto &a = particles.grid()[I], &b = elements.grid()[I];
            EXPECT_NEAR(a.m, b.m, 1e-13 * soft.rho * 0.3);
            EXPECT_LT((a.f - b.f).norm(), 1e-13 * soft.mu);  // the same sums of the same terms
            largest = std::max(largest, b.f.norm());
        }
        EXPECT_GT(largest, 0.1) << "hardly any force";
    }
}
TEST(TlmpmAtGaussPoints, HasTheForcesOfLinearElements) {
    for (const int gauss : {1, 2, 3}) expect_same_forces<1, Hat>(7, gauss);
}
TEST(TlmpmAtGaussPoints, HasTheForcesOfQuadraticElements) {
    for (const int gauss : {2, 3}) expect_same_forces<1, Lagrange2>(7, gauss);
}
TEST(TlmpmAtGaussPoints, HasTheForcesOfElementsInThePlane) {
    for (const int gauss : {1, 2, 3}) expect_same_forces<2, Hat>(4, gauss);
    for (const int gauss : {2, 3}) expect_same_forces<2, Lagrange2>(3, gauss);
}

/// One period of the manufactured segment at G = .05, strains of 16 %.
template <class Kernel> void expect_same_run(int cells, int gauss) {
    Segment<true> scene;
    scene.G = 0.05;
    scene.placing = "gauss";
    const double h = 1.0 / cells, dt = scene.period() / (10 * cells);
    Mesh<1, Tlmpm, Kernel, KeepNodes> particles(cells, gauss, h, scene.law(), Tlmpm{"usl"});
    Mesh<1, TotalFem, Kernel> elements(cells, gauss, h, scene.law());
    elements.start(scene);
    for (auto* points : {&particles.points(), &elements.points()})
        for (auto& p : *points) p.v = scene.initial_velocity(p.X);
    for (int I = 0; I < particles.grid().size(); ++I) particles.grid()[I].kept = elements.grid()[I].v;
    for (int k = 0; k < 10 * cells; ++k) {
        particles.run(scene, 1, dt);
        elements.run(scene, 1, dt);
        for (std::size_t i = 0; i < elements.points().size(); ++i) {
            EXPECT_NEAR(particles.points()[i].x[0], elements.points()[i].x[0], 1e-10 * scene.G);
            EXPECT_NEAR(particles.points()[i].v[0], elements.points()[i].v[0], 1e-10 * scene.speed());
            EXPECT_NEAR(particles.points()[i].sigma(0, 0), elements.points()[i].sigma(0, 0), 1e-10 * scene.E);
        }
        if (testing::Test::HasFailure()) return;
    }
}
TEST(TlmpmThatKeepsItsNodes, MovesAsLinearElements) {
    for (const int gauss : {1, 2, 3}) expect_same_run<Hat>(32, gauss);
}
TEST(TlmpmThatKeepsItsNodes, MovesAsQuadraticElements) { expect_same_run<Lagrange2>(16, 2); }

/// The remapping through the particles is what makes the difference: it lowers the frequency.
TEST(TlmpmThatRemaps, MovesOtherwise) {
    Segment<true> scene;
    scene.placing = "gauss";
    Mesh<1, Tlmpm> particles(32, 2, 1.0 / 32, scene.law());
    Mesh<1, TotalFem> elements(32, 2, 1.0 / 32, scene.law());
    elements.start(scene);
    for (auto& p : particles.points()) p.v = scene.initial_velocity(p.X);
    particles.run(scene, 160, scene.period() / 320);
    elements.run(scene, 160, scene.period() / 320);
    EXPECT_GT(std::abs(particles.points()[30].x[0] - elements.points()[30].x[0]), 1e-3 * scene.G);
}

}  // namespace
}  // namespace mpm::test
