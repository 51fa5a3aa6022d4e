// Prescribed rigid motions leave every kind of domain without stress, in updated- and in total-Lagrangian form.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "chapters/cpdi/tessellated.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/explicit/tlmpm.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "lab/boundary.hpp"
#include "lab/structured.hpp"

namespace mpm::test {
namespace {

const NeoHookean soft{30, 20, 1};
const Lattice<2> lattice(Vec<2>(-4, -4), Vec<2>(0.5, 0.4), {20, 24});
constexpr int steps = 200;
constexpr double dt = 0.01;

/// 3 x 3 cells of the kind, their inner corners displaced but for R4, whose domains start as rectangles.
template <class Domain> PolygonCells patch() {
    const Box box{Vec<2>(-0.9, -0.9), Vec<2>(0.9, 0.9)};
    PolygonCells mesh;
    const auto take = [&](const auto& cells) {
        mesh.points = cells.points;
        for (const auto& corners : cells.corners) mesh.corners.emplace_back(corners.begin(), corners.end());
    };
    if constexpr (std::is_same_v<Domain, DomainT3>) take(triangles_of(box, {3, 3}));
    else take(quadrilaterals_of(box, {3, 3}));
    if constexpr (std::is_same_v<Domain, DomainPolygon>) {  // two cells become one of six corners
        mesh.corners[0] = {0, 1, 2, 6, 5, 4};
        mesh.corners.erase(mesh.corners.begin() + 1);
    }
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shift(-0.12, 0.12);
    if constexpr (!std::is_same_v<Domain, DomainR4>)
        for (Vec<2>& x : mesh.points) x += Vec<2>(shift(random), shift(random));
    return mesh;
}

Mat<2> turned(double angle) {
    Mat<2> R;
    R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return R;
}

/// Nodes move so that x(t + dt) = R x(t) + shift: with the place x of a node or, on a total-Lagrangian grid, that of the material
/// which started at X.
template <bool TotalLagrangian> struct RigidMotion {
    double angle;  // of one step
    Vec<2> shift;
    template <class Body> void load(Body&, double) const {}
    template <class Nodes, class Field> void fix(Nodes& nodes, Field field, double t) const {
        Vec<2> from = Vec<2>::Zero();
        const long before = std::lround(t / dt) - 1;  // steps
        for (long n = 0; TotalLagrangian && n < before; ++n) from = turned(angle) * from + shift;
        const Mat<2> R = TotalLagrangian ? turned(angle * static_cast<double>(before)) : identity<2>();
        for (int I = 0; I < nodes.size(); ++I) {
            const Vec<2> x = R * lattice.position(I) + from;
            (nodes[I].*field) = nodes[I].m * (turned(angle) * x + shift - x) / dt;
        }
    }
};

template <class Domain, bool TotalLagrangian, class Scheme> void expect_no_stress(const Scheme& scheme, double angle, const Vec<2>& shift) {
    using Shape = typename ShapeOf<Domain, TotalLagrangian>::Shape;
    using OneBody = Body<2, Point<2>, Musl::NodeOf<2>, NeoHookean, Shape, Flip>;
    const PolygonCells mesh = patch<Domain>();
    std::vector<Point<2>> points = particles_at_centroids<Point<2>>(mesh, 1);
    Shape shape = shape_of_mesh<Domain, TotalLagrangian>(lattice, points, mesh);
    std::vector<OneBody> bodies;
    bodies.push_back(OneBody{{points, Grid<2, Musl::NodeOf<2>>(lattice), soft}, shape, Flip{}});
    const RigidMotion<TotalLagrangian> motion{angle, shift};
    for (int n = 0; n < steps; ++n) scheme.step(bodies, Free{}, motion, n * dt, dt);
    double moved = 0;
    for (const auto& p : bodies[0].points) {
        EXPECT_LT(p.sigma.norm(), 1e-10 * soft.mu);
        EXPECT_LT((p.F - turned(angle * steps)).norm(), 1e-11);
        moved = std::max(moved, (p.x - p.X).norm());
    }
    EXPECT_GT(moved, 0.5);  // it did move
}

template <class Domain> class RigidDomains : public testing::Test {};
using DomainTypes = testing::Types<DomainR4, DomainQ4, DomainT3, DomainPolygon>;
TYPED_TEST_SUITE(RigidDomains, DomainTypes);

// Hat functions carry linear fields exactly; rounding grows with the steps. Three quarters of a turn, so that the end is not the start.
TYPED_TEST(RigidDomains, TurnWithoutStress) {
    const double angle = 1.5 * M_PI / steps;
    expect_no_stress<TypeParam, false>(Musl{}, angle, Vec<2>(0.01, -0.005));
    expect_no_stress<TypeParam, true>(Tlmpm{}, angle, Vec<2>(0.01, -0.005));
}
TYPED_TEST(RigidDomains, MoveWithoutStress) {
    expect_no_stress<TypeParam, false>(Musl{}, 0, Vec<2>(0.012, -0.008));
    expect_no_stress<TypeParam, true>(Tlmpm{}, 0, Vec<2>(0.012, -0.008));
}

}  // namespace
}  // namespace mpm::test
