// Pressure on the edges of domains (review 4.2.3): which edges, how much, and where it goes.
#include "chapters/cpdi/edge_traction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "chapters/cpdi/corners.hpp"
#include "chapters/cpdi/tessellated.hpp"
#include "lab/structured.hpp"

namespace mpm::test {
namespace {

constexpr double a = 0.5, b = 1, p = 3;
const CellCounts counts{4, 9};
PolygonCells quarter() { return polygon_cells(quadrilaterals_of(Ring{Vec<2>::Zero(), a, b}, counts, 0, M_PI / 2)); }
bool is_inner(const Vec<2>& x) { return x.norm() < 0.55; }

/// Sum of the forces on all nodes, and of their moments about the origin.
struct Resultant {
    Vec<2> force = Vec<2>::Zero();
    double moment = 0;
};
template <class Force> Resultant resultant(const std::vector<LoadedEdge>& edges, const std::vector<Vec<2>>& places, const Force& force) {
    const Lattice<2> lattice(Vec<2>(-2, -2), Vec<2>(0.13, 0.11), {40, 50});
    Resultant sum;
    each_edge_force(edges, Corners<2>(lattice, places), force, [&](int I, const Vec<2>& f) {
        sum.force += f;
        sum.moment += cross(lattice.position(I), f);
    });
    return sum;
}

TEST(BoundaryEdges, AreThoseOfOneCellWithTheirOutwardNormals) {
    const PolygonCells mesh = quarter();
    const auto edges = boundary_edges(mesh, is_inner);
    ASSERT_EQ(edges.size(), 9u);
    for (const LoadedEdge& edge : edges) {
        const Vec<2> middle = (mesh.points[edge.from] + mesh.points[edge.to]) / 2;
        EXPECT_NEAR(edge.N.normalized().dot(middle.normalized()), -1, 1e-14);  // chords: middle and normal on one line
        EXPECT_NEAR(edge.N.norm(), 2 * a * std::sin(M_PI / 36), 1e-15);
    }
    EXPECT_EQ(boundary_edges(mesh, [](const Vec<2>&) { return true; }).size(), 2u * (4 + 9));
}

// The chords' projections on the axes are the arc's: p a on each. Hat functions reproduce linear fields, so that the moment is right
// too: none about the centre.
TEST(EdgePressure, SumsToThePressureOnTheArc) {
    const PolygonCells mesh = quarter();
    const auto edges = boundary_edges(mesh, is_inner);
    for (const Resultant& sum : {resultant(edges, mesh.points, DeadPressure{p}), resultant(edges, mesh.points, FollowerPressure{p})}) {
        EXPECT_LT((sum.force - Vec<2>(p * a, p * a)).norm(), 1e-14);
        EXPECT_NEAR(sum.moment, 0, 1e-14);
    }
}

// A closed boundary bears no resultant, however it has moved.
TEST(EdgePressure, OfAClosedBoundaryIsInBalanceIfItFollows) {
    PolygonCells mesh = quarter();
    const auto edges = boundary_edges(mesh, [](const Vec<2>&) { return true; });
    for (Vec<2>& x : mesh.points) x += Vec<2>(0.1 * std::sin(3 * x[1]), 0.2 * x[0] * x[0]);
    const Resultant follower = resultant(edges, mesh.points, FollowerPressure{p}), dead = resultant(edges, mesh.points, DeadPressure{p});
    EXPECT_LT(follower.force.norm(), 1e-13);
    EXPECT_NEAR(follower.moment, 0, 1e-13);
    EXPECT_LT(dead.force.norm(), 1e-13);
    EXPECT_GT(std::abs(dead.moment), 1e-3);  // dead forces turn what has moved
}

// Doubled and turned by a right angle: a follower turns and doubles with its edge, a dead load stays.
TEST(EdgePressure, FollowsItsEdgeOrNot) {
    const std::vector<Vec<2>> start{{0, 0}, {0.3, 0.1}}, now{{0, 0}, {-0.2, 0.6}};
    const std::vector<LoadedEdge> edge{{0, 1, edge_normal(start[0], start[1])}};
    EXPECT_LT((resultant(edge, now, FollowerPressure{p}).force - p * Vec<2>(-0.6, -0.2)).norm(), 1e-14);
    EXPECT_LT((resultant(edge, now, DeadPressure{p}).force - p * Vec<2>(-0.1, 0.3)).norm(), 1e-14);
}

}  // namespace
}  // namespace mpm::test
