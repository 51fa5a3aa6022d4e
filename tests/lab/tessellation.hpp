/// What holds for every tessellation, of triangles, quadrilaterals or polygons.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "lab/polygon.hpp"
#include "lab/triangles.hpp"

namespace mpm::test {

template <class Corners> Outline outline_of(const std::vector<Vec<2>>& points, const Corners& corners) {
    Outline outline;
    for (const int c : corners) outline.push_back(points.at(static_cast<std::size_t>(c)));
    return outline;
}

/// Cells that are simple, counter-clockwise, and meet along whole edges or not at all; no point is left over. Cells with edges on one side
/// of each and a boundary as long as the domain's have no gap between them, and no corner on a neighbour's edge.
template <class Mesh> void expect_tessellation(const Mesh& mesh, double area, double perimeter) {
    std::map<std::pair<int, int>, int> uses;
    std::vector<char> used(mesh.points.size(), 0);
    for (const auto& corners : mesh.corners) {
        const Outline outline = outline_of(mesh.points, corners);
        ASSERT_NO_THROW(Polygon{outline}) << "not simple";
        ASSERT_GT(signed_area(outline), 0);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            ++uses[{corners[k], corners[(k + 1) % corners.size()]}];
            used[static_cast<std::size_t>(corners[k])] = 1;
        }
    }
    double boundary = 0;
    for (const auto& [edge, n] : uses) {
        ASSERT_EQ(n, 1) << "two cells on one side of an edge";
        if (uses.count({edge.second, edge.first}) == 0)
            boundary += (mesh.points[static_cast<std::size_t>(edge.first)] - mesh.points[static_cast<std::size_t>(edge.second)]).norm();
    }
    EXPECT_NEAR(boundary, perimeter, 1e-12 * perimeter) << "edges without a neighbour are those of the domain";
    EXPECT_NEAR(mesh_area(mesh), area, 1e-12 * area);
    EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0) << "points of no cell";
}
template <class Mesh> void expect_tessellation(const Mesh& mesh, const Polygon& domain) {
    expect_tessellation(mesh, domain.area(), domain.perimeter());
}

/// For particle domains: 3 to 10 corners.
template <class Mesh> void expect_few_corners(const Mesh& mesh) {
    for (const auto& corners : mesh.corners) {
        EXPECT_GE(corners.size(), 3u);
        EXPECT_LE(corners.size(), 10u);
    }
}

}  // namespace mpm::test
