/// Triangle meshes of a polygon by Delaunay refinement (CGAL, behind mesh.cpp). Link target `mesh`, apart from `lab`: it is made with
/// CGAL's packages "2D Triangulations" and "2D Conforming Triangulations and Meshes", which are under the GPL, and so is every program that
/// links it.
#pragma once
#include "lab/polygon.hpp"
#include "lab/triangles.hpp"

namespace mpm {

/// Largest angle for which refinement is known to end [degree] (Shewchuk 2002): arcsin(2^(-3/2)).
inline constexpr double largest_min_angle = 20.7;

/// The corners of a polygon joined to triangles, as near to Delaunay's as its edges let them be; no point is added.
Triangles triangulate(const Polygon& domain);

/// A mesh whose edges are at most `size` [length] and whose angles are at least `min_angle` [degree], but where the polygon's own corners
/// are sharper. Every edge of the polygon is made of edges of the mesh. Throws BadInput unless size > 0 and 0 <= min_angle <=
/// largest_min_angle, and where more than `most` triangles were needed.
Triangles refine(const Polygon& domain, double size, double min_angle = 20, int most = 5000000);

}  // namespace mpm
