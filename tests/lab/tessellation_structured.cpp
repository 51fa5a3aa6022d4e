// Structured meshes: shared corners, areas, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <string>

#include "lab/mesh.hpp"
#include "lab/structured.hpp"
#include "tests/lab/tessellation.hpp"

namespace mpm::test {
namespace {

const Box box{{-1, 2}, {3, 3.5}};
const Ring ring{{2, -1}, 0.5, 1.25};
constexpr double pi = std::numbers::pi;

/// Of the ring whose circles have n corners.
double ring_area(int n) { return n / 2.0 * std::sin(2 * pi / n) * (ring.outer * ring.outer - ring.inner * ring.inner); }
double ring_perimeter(int n) { return 2 * n * std::sin(pi / n) * (ring.outer + ring.inner); }

TEST(StructuredBox, IsTiledByEqualQuadrilaterals) {
    const Quadrilaterals mesh = quadrilaterals_of(box, {7, 3});
    EXPECT_EQ(mesh.points.size(), 8u * 4u) << "corners are shared";
    ASSERT_EQ(mesh.corners.size(), 21u);
    expect_tessellation(mesh, box.area(), box.perimeter());
    for (std::size_t i = 0; i < 21; ++i) EXPECT_NEAR(cell_moments(mesh.points, mesh.corners[i], i).area, 6.0 / 21, 1e-15);
    EXPECT_EQ(mesh.points.front(), box.low);
    EXPECT_EQ(mesh.points.back(), box.high) << "exactly";
}
TEST(StructuredBox, IsTiledByTrianglesWithEitherDiagonals) {
    for (const Diagonals diagonals : {Diagonals::rising, Diagonals::alternating}) {
        const Triangles mesh = triangles_of(box, {4, 5}, diagonals);
        EXPECT_EQ(mesh.corners.size(), 40u);
        EXPECT_EQ(mesh.points.size(), 30u);
        expect_tessellation(mesh, box.area(), box.perimeter());
    }
}
TEST(StructuredBox, HasDiagonalsThatMeetByTurns) {
    const auto neighbours = [](const Triangles& mesh, int point) {
        std::set<int> all;
        for (const auto& c : mesh.corners)
            if (std::find(c.begin(), c.end(), point) != c.end()) all.insert(c.begin(), c.end());
        return all.size() - 1;
    };
    const int middle = 4;  // of 3 x 3 points
    EXPECT_EQ(neighbours(triangles_of(box, {2, 2}), middle), 6u);
    EXPECT_EQ(neighbours(triangles_of(box, {2, 2}, Diagonals::alternating), middle), 8u);
}
TEST(StructuredRing, IsClosedWhereItsEndsMeet) {
    for (const int n : {3, 16, 61}) {
        const Quadrilaterals mesh = quadrilaterals_of(ring, {4, n});
        EXPECT_EQ(mesh.points.size(), static_cast<std::size_t>(5 * n)) << "the seam's corners are shared";
        expect_tessellation(mesh, ring_area(n), ring_perimeter(n));
    }
}
TEST(StructuredRing, HasSectorsThatEndOnTheAxes) {
    const Quadrilaterals mesh = quadrilaterals_of(Ring{{0, 0}, 1, 2}, {3, 5}, 0, pi / 2);
    EXPECT_EQ(mesh.points.size(), 24u);
    expect_tessellation(mesh, 5 / 2.0 * std::sin(pi / 10) * 3, 2 + 2 * 5 * std::sin(pi / 20) * 3);
    for (const std::size_t i : {0u, 1u, 2u, 3u}) {
        EXPECT_EQ(mesh.points[i][1], 0) << "exactly, for symmetry conditions";
        EXPECT_EQ(mesh.points[20 + i][0], 0);
    }
}
TEST(StructuredRing, TakesAnyDirections) {
    for (const double from : {-7.0, -0.5 * pi, 1.0, 40.0}) {
        const Quadrilaterals mesh = quadrilaterals_of(ring, {2, 9}, from, from + 2);
        const double part = 9 / 2.0 * std::sin(2.0 / 9) * (ring.outer * ring.outer - ring.inner * ring.inner);
        expect_tessellation(mesh, part, 2 * (ring.outer - ring.inner) + 18 * std::sin(1.0 / 9) * (ring.outer + ring.inner));
        EXPECT_NEAR((mesh.points[0] - ring.centre - ring.inner * Vec<2>(std::cos(from), std::sin(from))).norm(), 0, 1e-14)
            << "angles of 40 have an error of 1e-15";
    }
}
TEST(QuadrilateralsOfTriangles, AreThreeInEachAndShareTheMiddles) {
    const Polygon frame({{0, 0}, {2, 0}, {2, 1.5}, {0, 1}}, {circle(Vec<2>(0.6, 0.5), 0.3, 30), {{1.2, 0.4}, {1.2, 0.8}, {1.7, 0.6}}});
    const Triangles triangles = refine(frame, 0.2);
    expect_tessellation(triangles, frame);
    const Quadrilaterals mesh = quadrilaterals_of(triangles);
    ASSERT_EQ(mesh.corners.size(), 3 * triangles.corners.size());
    expect_tessellation(mesh, frame);
    for (std::size_t i = 0; i < mesh.corners.size(); ++i)
        EXPECT_NEAR(cell_moments(mesh.points, mesh.corners[i], i).area,
                    cell_moments(triangles.points, triangles.corners[i / 3], i / 3).area / 3, 1e-16);
}
TEST(QuadrilateralsOfTriangles, TurnClockwiseOnesRound) {
    const Quadrilaterals mesh = quadrilaterals_of(Triangles{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {{0, 1, 2}, {0, 3, 2}}});
    EXPECT_EQ(mesh.corners.size(), 6u);
    expect_tessellation(mesh, 2, 6);
}

std::string refusal(const std::function<void()>& act) {
    try {
        act();
    } catch (const BadInput& bad) {
        return bad.what();
    }
    return "none";
}
TEST(StructuredMeshes, RefuseWhatHasNoCells) {
    EXPECT_EQ(refusal([] { quadrilaterals_of(box, {0, 3}); }), "mesh: 0 x 3 cells: allowed 1 ... 5000000 in all");
    EXPECT_EQ(refusal([] { triangles_of(box, {3, -1}); }), "mesh: 3 x -1 cells: allowed 1 ... 5000000 in all");
    EXPECT_EQ(refusal([] {
                  quadrilaterals_of(box, {2000000000, 2000000000});
              }),
              "mesh: 2000000000 x 2000000000 cells: allowed 1 ... 5000000 in all");
    EXPECT_EQ(refusal([] { quadrilaterals_of(Box{{0, 0}, {1, 0}}, {1, 1}); }), "mesh: the box from (0, 0) to (1, 0) has no area");
    EXPECT_EQ(refusal([] {
                  quadrilaterals_of(Ring{{0, 0}, 0, 1}, {1, 8});
              }),
              "mesh: ring between the radii 0 and 1: allowed 0 < inner < outer");
    EXPECT_EQ(refusal([] { quadrilaterals_of(ring, {1, 8}, 1, 1); }), "mesh: sector from 1 to 1: allowed 0 < to - from <= 2 pi");
    EXPECT_EQ(refusal([] {
                  quadrilaterals_of(ring, {1, 8}, 0, std::nan(""));
              }),
              "mesh: sector from 0 to nan: allowed 0 < to - from <= 2 pi");
    EXPECT_EQ(refusal([] { quadrilaterals_of(ring, {1, 2}); }), "mesh: 2 cells around: a cell must span less than half a turn");
    EXPECT_EQ(refusal([] { quadrilaterals_of(Triangles{{{0, 0}, {1, 0}, {2, 0}}, {{0, 1, 2}}}); }), "mesh: cell 0 encloses no area");
}

// Halves of a ring's cells cover what the cells do, whichever diagonal cuts them.
TEST(StructuredRing, IsCoveredByHalvesOfItsCells) {
    const CellCounts n{3, 7};
    const Quadrilaterals cells = quadrilaterals_of(Ring{Vec<2>(1, 2), 0.5, 1.5}, n, 0, 1.2);
    for (const Diagonals diagonals : {Diagonals::rising, Diagonals::alternating}) {
        const Triangles halves = triangles_of(cells, n, diagonals);
        EXPECT_EQ(halves.corners.size(), 2 * cells.corners.size());
        EXPECT_NEAR(mesh_area(halves), mesh_area(cells), 1e-14);
    }
}

}  // namespace
}  // namespace mpm::test
