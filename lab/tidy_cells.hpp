/// Makes clipped cells fit to be particle domains: joins slivers to neighbours, cuts cells of many corners, removes tiny edges. Neighbours
/// keep sharing whole edges, and the area of all stays.
#pragma once
#include "lab/triangles.hpp"
#include "lab/voronoi_clip.hpp"

namespace mpm {

/// Each part of a cell that is not its largest, and is smaller than `least` [length^2], joins the neighbour it shares the longest boundary
/// with, if both together are a simple polygon of at most `most` corners; otherwise it stays a cell of its own.
void join_small_parts(double least, std::size_t most, ClippedCells& cells);

/// Cuts cells of more than `most` corners (at least 4) in two, and again, along the diagonal that leaves the two roundest parts.
void cut_cells(std::size_t most, ClippedCells& cells);

/// Edges shorter than `shortest` [length] become one point for all cells around, where these stay simple polygons and the outline stays.
void collapse_short_edges(double shortest, ClippedCells& cells);

/// The cells with the points they use.
PolygonCells compact(const ClippedCells& cells);

/// Whether the corners make a simple polygon, counter-clockwise.
bool is_simple(const std::vector<Vec<2>>& points, const std::vector<int>& corners);

}  // namespace mpm
