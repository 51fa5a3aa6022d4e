/// How the domains of Tessellated scenes become weighting functions, by the names of `--shape`.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "chapters/cpdi/domains.hpp"
#include "chapters/cpdi/parallelograms.hpp"
#include "chapters/cpdi/polygons.hpp"
#include "chapters/cpdi/q4.hpp"
#include "chapters/cpdi/r4.hpp"
#include "chapters/cpdi/t3.hpp"
#include "lab/assemble.hpp"
#include "lab/tessellated.hpp"

namespace mpm {

/// The cells of a mesh of triangles or quadrilaterals.
template <class Mesh> PolygonCells polygon_cells(const Mesh& mesh) {
    PolygonCells cells{mesh.points, {}};
    for (const auto& corners : mesh.corners) cells.corners.emplace_back(corners.begin(), corners.end());
    return cells;
}

/// Turns the cells of a mesh that run clockwise.
inline PolygonCells counter_clockwise(PolygonCells mesh) {
    for (std::vector<int>& cell : mesh.corners) {
        const auto corner = [&](std::size_t c) -> const Vec<2>& { return mesh.points[static_cast<std::size_t>(cell[c])]; };
        if (DomainPolygon::size(cell.size(), corner).V < 0) std::reverse(cell.begin(), cell.end());
    }
    return mesh;
}

/// The domains of a mesh whose cells all have the corners of `Domain`.
template <class Domain, bool TotalLagrangian>
Domains<Domain, TotalLagrangian> domains_of(const Lattice<2>& lattice, const PolygonCells& mesh) {
    typename Domains<Domain, TotalLagrangian>::Of of(mesh.corners.size());
    for (std::size_t i = 0; i < of.size(); ++i) {
        if (mesh.corners[i].size() != Domain::corners)
            throw BadInput(std::string("--shape ") + Domain::name + ": domain " + std::to_string(i) + " has " +
                           std::to_string(mesh.corners[i].size()) + " corners");
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
        for (const int c : cell) {
            const Vec<2>& corner = mesh.points[static_cast<std::size_t>(c)];
            low = low.cwiseMin(corner), high = high.cwiseMax(corner);
        }
        half.push_back(0.5 * (high - low));
    }
    return {lattice, points, std::move(half)};
}

/// The names that `--shape` takes.
inline std::vector<std::string> domain_names() { return {DomainR4::name, DomainQ4::name, DomainT3::name, DomainPolygon::name}; }

/// The weighting function of a body that is tessellated into such domains; `shape_of_mesh` makes it.
template <class Domain, bool TotalLagrangian> struct ShapeOf {
    using Shape = Domains<Domain, TotalLagrangian>;
};
template <bool TotalLagrangian> struct ShapeOf<DomainR4, TotalLagrangian> {
    using Shape = Parallelograms<DomainR4, TotalLagrangian>;
};
template <bool TotalLagrangian> struct ShapeOf<DomainPolygon, TotalLagrangian> {
    using Shape = Polygons<TotalLagrangian>;
};
template <class Domain, bool TotalLagrangian, class Points>
typename ShapeOf<Domain, TotalLagrangian>::Shape shape_of_mesh(const Lattice<2>& lattice, const Points& points, const PolygonCells& mesh) {
    if constexpr (std::is_same_v<Domain, DomainR4>) return rectangles_of<TotalLagrangian>(lattice, points, mesh);
    else if constexpr (std::is_same_v<Domain, DomainPolygon>) return Polygons<TotalLagrangian>(lattice, mesh.points, mesh.corners);
    else return domains_of<Domain, TotalLagrangian>(lattice, mesh);
}

/// One resolution of a Tessellated scene with one kind of domains.
template <class Domain, bool TotalLagrangian, class Scheme, class Scene, class Transfer>
Assembled assemble_domain(const Scheme& scheme, const Scene& plain, const Transfer& transfer, int cells, const Common& common) {
    Scene scene = plain;
    std::vector<PolygonCells> meshes;
    for (PolygonCells& mesh : scene.tessellate(Domain::name, cells, common.ppc)) meshes.push_back(counter_clockwise(std::move(mesh)));
    scene.domains = std::make_shared<const std::vector<PolygonCells>>(std::move(meshes));
    std::size_t body = 0;
    return assemble<typename ShapeOf<Domain, TotalLagrangian>::Shape>(
        scheme, scene, transfer, ShapeFacts{Domain::name, 1, 2}, cells, common, [&](const auto& lattice, const auto& points) {
            return shape_of_mesh<Domain, TotalLagrangian>(lattice, points, (*scene.domains)[body++]);
        });
}

/// The same with the domains that `--shape` names.
template <bool TotalLagrangian, class Scheme, class Scene, class Transfer>
Assembled assemble_domains(const Scheme& scheme, const Scene& scene, const Transfer& transfer, int cells, const Common& common) {
    if (common.shape == DomainR4::name) return assemble_domain<DomainR4, TotalLagrangian>(scheme, scene, transfer, cells, common);
    if (common.shape == DomainQ4::name) return assemble_domain<DomainQ4, TotalLagrangian>(scheme, scene, transfer, cells, common);
    if (common.shape == DomainT3::name) return assemble_domain<DomainT3, TotalLagrangian>(scheme, scene, transfer, cells, common);
    return assemble_domain<DomainPolygon, TotalLagrangian>(scheme, scene, transfer, cells, common);
}

}  // namespace mpm
