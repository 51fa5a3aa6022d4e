/// Meshes of a plane domain as plain vectors, and the particles made of them (review 4.1.2): at centroids or at Gauss points, each with its
/// share of the area. Cells may run either way round.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "lab/fill.hpp"
#include "lab/math.hpp"
#include "lab/options.hpp"

namespace mpm {

struct Triangles {
    std::vector<Vec<2>> points;               // [length]
    std::vector<std::array<int, 3>> corners;  // numbers of points
};
/// Cells with any number of corners, each a simple polygon.
struct PolygonCells {
    std::vector<Vec<2>> points;             // [length]
    std::vector<std::vector<int>> corners;  // numbers of points, in order
};

/// Area [length^2] and centroid of a cell.
struct CellMoments {
    double area = 0;
    Vec<2> centroid = Vec<2>::Zero();
};

/// Moments of the cell with these corners, from triangles at the first one. Throws BadInput, naming the cell (counted from 0), for fewer
/// than three corners, a corner that is no point of the mesh or no number, and for a cell without area.
template <class Corners> CellMoments cell_moments(const std::vector<Vec<2>>& points, const Corners& corners, std::size_t number) {
    const auto refuse = [&](const std::string& what) { return BadInput("mesh: cell " + std::to_string(number) + " " + what); };
    if (corners.size() < 3) throw refuse("has " + std::to_string(corners.size()) + " corners, at least 3 are needed");
    for (const int c : corners) {
        if (c < 0 || static_cast<std::size_t>(c) >= points.size())
            throw refuse("has the corner " + std::to_string(c) + ", but the mesh has " + std::to_string(points.size()) + " points");
        if (!points[static_cast<std::size_t>(c)].allFinite()) throw refuse("has the corner " + std::to_string(c) + ", which is no number");
    }
    const auto corner = [&](std::size_t i) -> const Vec<2>& { return points[static_cast<std::size_t>(corners[i])]; };
    double area = 0;
    Vec<2> moment = Vec<2>::Zero();
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const Vec<2> a = corner(i - 1) - corner(0), b = corner(i) - corner(0);
        const double part = (a[0] * b[1] - a[1] * b[0]) / 2;
        area += part;
        moment += part * (a + b) / 3;
    }
    if (!(std::abs(area) > 0)) throw refuse("encloses no area");
    return {std::abs(area), corner(0) + moment / area};
}

/// Area of a mesh [length^2]. Throws BadInput for a mesh without cells and as cell_moments does.
template <class Mesh> double mesh_area(const Mesh& mesh) {
    if (mesh.corners.empty()) throw BadInput("mesh: it has no cells");
    double sum = 0;
    for (std::size_t i = 0; i < mesh.corners.size(); ++i) sum += cell_moments(mesh.points, mesh.corners[i], i).area;
    return sum;
}

/// One particle at the centroid of each cell of Triangles or PolygonCells: exact for linear functions. Throws BadInput as mesh_area does.
template <class Point, class Mesh> std::vector<Point> particles_at_centroids(const Mesh& mesh, double rho) {
    if (mesh.corners.empty()) throw BadInput("mesh: it has no cells");
    std::vector<Point> all;
    for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
        const CellMoments cell = cell_moments(mesh.points, mesh.corners[i], i);
        all.push_back(particle_at<Point>(cell.centroid, cell.area, rho));
    }
    return all;
}

/// Three particles in each triangle, at its Gauss points (area coordinates 2/3, 1/6, 1/6) with a third of the area each: exact for
/// quadratic functions. Throws BadInput as mesh_area does.
template <class Point> std::vector<Point> particles_at_gauss_points(const Triangles& mesh, double rho) {
    if (mesh.corners.empty()) throw BadInput("mesh: it has no cells");
    std::vector<Point> all;
    for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
        const CellMoments cell = cell_moments(mesh.points, mesh.corners[i], i);
        for (const int c : mesh.corners[i])
            all.push_back(particle_at<Point>((cell.centroid + mesh.points[static_cast<std::size_t>(c)]) / 2, cell.area / 3, rho));
    }
    return all;
}

/// Smallest angle of all triangles [degree].
inline double smallest_angle(const Triangles& mesh) {
    double smallest = 180;
    for (const auto& corners : mesh.corners)
        for (const std::size_t i : {0u, 1u, 2u}) {
            const auto corner = [&](std::size_t k) -> const Vec<2>& { return mesh.points[static_cast<std::size_t>(corners[(i + k) % 3])]; };
            const Vec<2> a = corner(1) - corner(0), b = corner(2) - corner(0);
            smallest = std::min(smallest, std::atan2(std::abs(a[0] * b[1] - a[1] * b[0]), a.dot(b)) * 180 / std::numbers::pi);
        }
    return smallest;
}

}  // namespace mpm
