/// Scenes whose bodies are tessellated into particle domains, and how these become weighting functions by the names of `--shape`.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "chapters/cpdi/domains.hpp"
#include "chapters/cpdi/parallelograms.hpp"
#include "chapters/cpdi/polygons.hpp"
#include "chapters/cpdi/q4.hpp"
#include "chapters/cpdi/r4.hpp"
#include "chapters/cpdi/t3.hpp"
#include "lab/assemble.hpp"
#include "lab/triangles.hpp"

namespace mpm {

/// What a scene with domains is made of: one tessellation for each body, its cells counter-clockwise. `assemble_domains` fills it in by the
/// scene's tessellate(shape, cells, ppc), so that particles and weighting functions have the same domains.
struct Tessellated {
    std::shared_ptr<const std::vector<PolygonCells>> domains = {};

    /// One particle in each domain, at its centroid and with its area; `set(point)` gives it what else it needs.
    template <class Point, class Set> std::vector<std::vector<Point>> bodies_of(double rho, Set&& set) const {
        std::vector<std::vector<Point>> all;
        for (const PolygonCells& cells : *domains) {
            all.push_back(particles_at_centroids<Point>(cells, rho));
            for (Point& p : all.back()) set(p);
        }
        return all;
    }
};

/// The cells of a mesh of triangles or quadrilaterals.
template <class Mesh> PolygonCells polygon_cells(const Mesh& mesh) {
    PolygonCells cells{mesh.points, {}};
    for (const auto& corners : mesh.corners) cells.corners.emplace_back(corners.begin(), corners.end());
    return cells;
}

/// Turns the cells of a mesh that run clockwise.
inline PolygonCells counter_clockwise(PolygonCells mesh) {
    for (std::vector<int>& cell : mesh.corners) {
        double twice_area = 0;
        for (std::size_t c = 0; c < cell.size(); ++c)
            twice_area += cross(mesh.points[static_cast<std::size_t>(cell[c])], mesh.points[static_cast<std::size_t>(cell[(c + 1) % cell.size()])]);
        if (twice_area < 0) std::reverse(cell.begin(), cell.end());
    }
    return mesh;
}

/// The domains of a mesh whose cells all have the corners of `Domain`.
template <class Domain, bool TotalLagrangian> Domains<Domain, TotalLagrangian> domains_of(const Lattice<2>& lattice, const PolygonCells& mesh) {
    typename Domains<Domain, TotalLagrangian>::Of of(mesh.corners.size());
    for (std::size_t i = 0; i < of.size(); ++i) {
        if (mesh.corners[i].size() != Domain::corners)
            throw BadInput(std::string("--shape ") + Domain::name + ": domain " + std::to_string(i) + " has " + std::to_string(mesh.corners[i].size()) +
                           " corners");
        std::copy(mesh.corners[i].begin(), mesh.corners[i].end(), of[i].begin());
    }
    return {lattice, mesh.points, std::move(of)};
}

/// The rectangles around the cells of a mesh, which should be rectangles themselves.
template <bool TotalLagrangian, class Points>
Parallelograms<DomainR4, TotalLagrangian> rectangles_of(const Lattice<2>& lattice, const Points& points, const PolygonCells& mesh) {
    std::vector<Vec<2>> half;
    for (const std::vector<int>& cell : mesh.corners) {
        Vec<2> low = mesh.points[static_cast<std::size_t>(cell[0])], high = low;
        for (const int c : cell) low = low.cwiseMin(mesh.points[static_cast<std::size_t>(c)]), high = high.cwiseMax(mesh.points[static_cast<std::size_t>(c)]);
        half.push_back(0.5 * (high - low));
    }
    return {lattice, points, std::move(half)};
}

/// The names that `--shape` takes.
inline std::vector<std::string> domain_names() { return {DomainR4::name, DomainQ4::name, DomainT3::name, DomainPolygon::name}; }

/// One resolution of a Tessellated scene with the domains that `--shape` names.
template <bool TotalLagrangian, class Scheme, class Scene, class Transfer>
Assembled assemble_domains(const Scheme& scheme, const Scene& plain, const Transfer& transfer, int cells, const Common& common) {
    Scene scene = plain;
    std::vector<PolygonCells> meshes;
    for (PolygonCells& mesh : scene.tessellate(common.shape, cells, common.ppc)) meshes.push_back(counter_clockwise(std::move(mesh)));
    scene.domains = std::make_shared<const std::vector<PolygonCells>>(std::move(meshes));
    std::size_t body = 0;
    const auto next = [&]() -> const PolygonCells& { return (*scene.domains)[body++]; };
    const auto with = [&]<class Shape>(const char* name, auto make) {
        return assemble<Shape>(scheme, scene, transfer, ShapeFacts{name, 1, 2}, cells, common, make);
    };
    if (common.shape == DomainR4::name)
        return with.template operator()<Parallelograms<DomainR4, TotalLagrangian>>(
            DomainR4::name, [&](const auto& lattice, const auto& points) { return rectangles_of<TotalLagrangian>(lattice, points, next()); });
    if (common.shape == DomainQ4::name)
        return with.template operator()<Domains<DomainQ4, TotalLagrangian>>(
            DomainQ4::name, [&](const auto& lattice, const auto&) { return domains_of<DomainQ4, TotalLagrangian>(lattice, next()); });
    if (common.shape == DomainT3::name)
        return with.template operator()<Domains<DomainT3, TotalLagrangian>>(
            DomainT3::name, [&](const auto& lattice, const auto&) { return domains_of<DomainT3, TotalLagrangian>(lattice, next()); });
    return with.template operator()<Polygons<TotalLagrangian>>(DomainPolygon::name, [&](const auto& lattice, const auto&) {
        const PolygonCells& mesh = next();
        return Polygons<TotalLagrangian>(lattice, mesh.points, mesh.corners);
    });
}

}  // namespace mpm
