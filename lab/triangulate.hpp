/// Delaunay triangulation of points in a plane; CGAL stays behind the .cpp, a link target of its own.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace mpm {

using Triangle = std::array<std::size_t, 3>;  // numbers of points, counter-clockwise

/// The triangles between all points, whose convex hull they fill; none if all points lie on one line. Points must be finite and no two of
/// them equal.
std::vector<Triangle> triangulate(const std::vector<std::array<double, 2>>& points);

}  // namespace mpm
