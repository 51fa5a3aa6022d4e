/// Voronoi cells of a polygon as particle domains (review 3.6.6). Link target `mesh`: it uses CGAL's packages under the GPL, as
/// lab/mesh.hpp does.
///
/// A cell is what is nearest to its seed of the polygon. Where the polygon divides a cell, parts smaller than a quarter of the mean join a
/// neighbour and others are cells of their own; a cell that goes around a hole is cut to the hole's left and right; one of more than
/// ten corners (along a finely drawn outline) is cut in two. So there may be more cells than seeds. Edges shorter than 2 % of the mean
/// spacing become points, but for those of triangles and of the polygon. Cells are simple polygons of 3 to 10 corners, counter-clockwise,
/// and neighbours share whole edges; at reflex corners of the polygon they may be concave.
#pragma once
#include <cstdint>
#include <vector>

#include "lab/polygon.hpp"
#include "lab/triangles.hpp"

namespace mpm {

/// Lloyd's method: seeds move to the centroids of their cells, again and again (Du, Faber and Gunzburger 1999).
struct Lloyd {
    int iterations = 50;     // at most
    double tolerance = 0;    // ends when no seed moves more than this part of the mean spacing sqrt(area / cells) [-]
    std::uint64_t seed = 1;  // of the random places to start from; the same ones give the same cells
};

struct CentroidalCells {
    PolygonCells cells;
    int iterations = 0;  // done
    double moved = 0;    // the longest way of a seed in the last one, over the mean spacing [-]
};

/// Cells of equal weight all over the polygon, `cells` of them or some more (above). Throws BadInput unless 1 <= cells <= 5e6, for fewer
/// than 0 iterations and a negative tolerance, and where cells are too small for the digits of the coordinates.
CentroidalCells centroidal_voronoi(const Polygon& domain, long cells, const Lloyd& lloyd = {});

/// Cells of seeds that lie within the polygon's bounds. Throws BadInput for others, for two in one place, and as centroidal_voronoi does.
PolygonCells voronoi(const Polygon& domain, std::vector<Vec<2>> seeds);

}  // namespace mpm
