/// The Voronoi diagram of points as plain vectors (CGAL, behind voronoi_diagram.cpp). Link target `mesh` (lab/mesh.hpp).
#pragma once
#include <cstddef>
#include <vector>

#include "lab/geometry.hpp"
#include "lab/math.hpp"

namespace mpm {

/// One edge of a cell: it starts at vertex `from`, runs counter-clockwise to the next edge's, and `beyond` lies the cell of that seed.
struct VoronoiEdge {
    int from, beyond;
};

/// Cells of `seeds`, which are followed by a few far away that bound the others and have no edges themselves.
struct VoronoiDiagram {
    std::vector<Vec<2>> seeds, vertices;  // [length]
    std::vector<VoronoiEdge> edges;       // cell after cell
    std::vector<std::size_t> first;       // the edges of cell i are first[i] ... first[i + 1] - 1

    int count(int i) const { return static_cast<int>(first[static_cast<std::size_t>(i) + 1] - first[static_cast<std::size_t>(i)]); }
    /// Edge k of cell i; after the last comes the first again.
    const VoronoiEdge& edge(int i, int k) const {
        return edges[first[static_cast<std::size_t>(i)] + static_cast<std::size_t>(k % count(i))];
    }
    const Vec<2>& seed(int i) const { return seeds[static_cast<std::size_t>(i)]; }
    const Vec<2>& vertex(int v) const { return vertices[static_cast<std::size_t>(v)]; }

    /// The seed nearest to x, looked for from `start` on.
    int nearest(const Vec<2>& x, int start) const;
};

/// The diagram, exact within `bounds`, of seeds that lie there. Vertices nearer to each other than `merge` become one. Seeds in an order in
/// which neighbours follow each other are fastest (along_a_curve). Throws BadInput for two seeds in one place.
VoronoiDiagram voronoi_diagram(const std::vector<Vec<2>>& seeds, const Bounds& bounds, double merge);

/// Puts points into an order in which those that follow each other are near (a Hilbert curve).
void along_a_curve(std::vector<Vec<2>>& points);

}  // namespace mpm
