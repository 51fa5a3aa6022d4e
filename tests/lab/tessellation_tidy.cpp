// The parts of tessellating that stand alone: faces of edges, cutting, joining and collapsing of cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lab/plane_graph.hpp"
#include "lab/tidy_cells.hpp"
#include "lab/voronoi.hpp"
#include "lab/voronoi_contacts.hpp"
#include "tests/lab/tessellation.hpp"

namespace mpm::test {
namespace {

TEST(FacesOfEdges, AreOnTheirLeft) {
    // A square with one diagonal: two triangles, and the outside all around.
    const FaceLoops faces = trace_faces({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}});
    ASSERT_EQ(faces.loops.size(), 3u);
    const auto edges = [&](int half) {
        return faces.loops[static_cast<std::size_t>(faces.loop_of[static_cast<std::size_t>(half)])].size();
    };
    EXPECT_EQ(edges(0), 3u) << "from 0 to 1, the lower triangle";
    EXPECT_EQ(edges(4), 3u) << "from 2 to 3, the upper one";
    EXPECT_EQ(edges(1), 4u) << "from 1 to 0, outside";
    EXPECT_NE(faces.loop_of[8], faces.loop_of[9]) << "the diagonal lies between two";
}
TEST(FacesOfEdges, HaveALoopForEachOutline) {
    const FaceLoops faces =
        trace_faces({{0, 0}, {3, 0}, {0, 3}, {0.5, 0.5}, {1, 0.5}, {0.5, 1}}, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}});
    EXPECT_EQ(faces.loops.size(), 4u) << "two triangles from inside and outside";
}

ClippedCells one_cell(const Outline& outline) {
    ClippedCells cells{outline, std::vector<int>(outline.size(), fixed_point), {{}}, {0}};
    for (std::size_t k = 0; k < outline.size(); ++k) cells.corners[0].push_back(static_cast<int>(k));
    return cells;
}
TEST(CutCells, KeepAreaAndCorners) {
    Outline comb, gear = circle({0, 0}, 1, 48);
    for (int k = 0; k < 12; ++k) comb.insert(comb.end(), {{2.0 * k, 1}, {2.0 * k, 0.1}, {2.0 * k + 1, 0.1}, {2.0 * k + 1, 1}});
    comb.insert(comb.end(), {{23.5, 0}, {-0.5, 0}});
    std::reverse(comb.begin(), comb.end());
    for (std::size_t k = 0; k < gear.size(); k += 3) gear[k] *= 0.5;
    for (const Outline& outline : {circle({3, 4}, 2, 11), circle({3, 4}, 2, 500), gear, comb}) {
        ClippedCells cells = one_cell(outline);
        cut_cells(10, cells);
        EXPECT_GT(cells.corners.size(), outline.size() / 10);
        expect_few_corners(cells);
        expect_tessellation(compact(cells), Polygon(outline));
    }
}
TEST(CutCells, CutAHalfRingAcross) {
    Outline half;
    for (int k = 0; k <= 8; ++k) half.emplace_back(std::cos(k * std::numbers::pi / 8), std::sin(k * std::numbers::pi / 8));
    for (int k = 8; k >= 0; --k) half.push_back(0.8 * half[static_cast<std::size_t>(k)]);
    ClippedCells cells = one_cell(half);
    cut_cells(10, cells);
    EXPECT_EQ(cells.corners.size(), 2u) << "with the cut that leaves the two roundest parts";
    expect_tessellation(compact(cells), Polygon(half));
}
TEST(SimplePolygons, DoNotTouchThemselves) {
    const std::vector<Vec<2>> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0}, {2, 0}};
    EXPECT_TRUE(is_simple(points, {0, 1, 2, 3}));
    EXPECT_TRUE(is_simple(points, {0, 4, 1, 2, 3})) << "a straight corner is one";
    EXPECT_FALSE(is_simple(points, {0, 3, 2, 1})) << "clockwise";
    EXPECT_FALSE(is_simple(points, {0, 1, 3, 2}));
    EXPECT_FALSE(is_simple(points, {0, 1, 2, 4, 3})) << "touches its own edge";
    EXPECT_FALSE(is_simple(points, {0, 5, 1, 2, 3})) << "runs back";
    EXPECT_FALSE(is_simple(points, {0, 1}));
}

/// Two unit squares beside each other, the edge between them divided near its middle.
ClippedCells divided(double length) {
    return {{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}, {1, 0.5 - length}, {1, 0.5}},
            {fixed_point, 0, fixed_point, fixed_point, 2, fixed_point, free_point, free_point},
            {{0, 1, 6, 7, 4, 5}, {1, 2, 3, 4, 7, 6}},
            {0, 1}};
}
TEST(ShortEdges, BecomePointsForAllCellsAround) {
    ClippedCells cells = divided(0.01);
    collapse_short_edges(0.02, cells);
    for (const auto& corners : cells.corners) EXPECT_EQ(corners.size(), 5u);
    expect_tessellation(compact(cells), 2, 6);
    cells = divided(0.03);
    collapse_short_edges(0.02, cells);
    for (const auto& corners : cells.corners) EXPECT_EQ(corners.size(), 6u);
}
TEST(ShortEdges, StayWhereTheOutlineHasThem) {
    const Outline outline{{0, 0}, {1, 0}, {1, 0.01}, {0, 1}};
    ClippedCells cells = one_cell(outline);
    collapse_short_edges(0.02, cells);
    EXPECT_EQ(cells.corners[0].size(), 4u);
}
TEST(ShortEdges, AreFewInTessellations) {
    const Polygon square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    const PolygonCells mesh = centroidal_voronoi(square, 2000, {0}).cells;
    int edges = 0, tiny = 0;
    for (const auto& corners : mesh.corners) {
        const Outline outline = outline_of(mesh.points, corners);
        for (std::size_t k = 0; k < outline.size(); ++k, ++edges)
            tiny += (outline[(k + 1) % outline.size()] - outline[k]).norm() < 0.02 / std::sqrt(2000) ? 1 : 0;
    }
    EXPECT_LE(tiny, edges / 1000) << "those of triangles, which would lose their area";
}

TEST(SmallParts, JoinTheNeighbourWithTheLongestEdge) {
    // Cell 0 in the middle, cell 1 above it and, a sliver, below.
    ClippedCells cells{{{0, 0}, {1, 0}, {1, 0.1}, {0, 0.1}, {1, 1}, {0, 1}, {1, 2}, {0, 2}},
                       std::vector<int>(8, fixed_point),
                       {{0, 1, 2, 3}, {3, 2, 4, 5}, {5, 4, 6, 7}},
                       {1, 0, 1}};
    ClippedCells kept = cells;
    join_small_parts(0.05, 10, kept);
    EXPECT_EQ(kept.corners.size(), 3u) << "large enough";
    join_small_parts(0.2, 10, cells);
    ASSERT_EQ(cells.corners.size(), 2u);
    EXPECT_EQ(cells.seed, (std::vector<int>{0, 1}));
    expect_tessellation(compact(cells), 2, 6);
}

}  // namespace
}  // namespace mpm::test
