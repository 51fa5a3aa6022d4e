/// Cells of a Voronoi diagram clipped to a polygon. Link target `mesh` (lab/mesh.hpp).
#pragma once
#include <vector>

#include "lab/polygon.hpp"
#include "lab/voronoi_diagram.hpp"

namespace mpm {

/// Parts of cells, counter-clockwise; neighbours have the same points along what they share.
struct ClippedCells {
    std::vector<Vec<2>> points;             // [length]; not all are used
    std::vector<int> kinds;                 // of each point, as in lab/voronoi_contacts.hpp
    std::vector<std::vector<int>> corners;  // numbers of points
    std::vector<int> seed;                  // of the cell it is a part of; one cell may have several parts, or none
};

/// A cell that goes around a hole is cut to the left and right of it, one that the outline divides has several parts. A vertex within
/// `reach` of the outline moves onto it.
ClippedCells clip(const VoronoiDiagram& diagram, const Polygon& domain, double reach);

}  // namespace mpm
