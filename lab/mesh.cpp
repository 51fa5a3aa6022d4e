#include "lab/mesh.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "lab/record.hpp"

namespace mpm {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Storage = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Storage>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
using Mesher = CGAL::Delaunay_mesher_2<Triangulation, Criteria>;
using Face = Triangulation::Face_handle;
using Faces = std::unordered_set<Face, CGAL::Handle_hash_function>;

void add(const Outline& outline, Triangulation& triangulation) {
    std::vector<Triangulation::Vertex_handle> corners;
    Face near{};
    for (const Vec<2>& x : outline) {
        corners.push_back(triangulation.insert({x[0], x[1]}, near));
        near = corners.back()->face();
    }
    for (std::size_t i = 0; i < corners.size(); ++i) triangulation.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
}

/// The faces that are reached from `start` without crossing the outlines, and those first met beyond them.
void flood(const Triangulation& triangulation, Face start, Faces& seen, std::vector<Face>& beyond) {
    std::vector<Face> stack{start};
    while (!stack.empty()) {
        const Face face = stack.back();
        stack.pop_back();
        if (!seen.insert(face).second) continue;
        for (const int i : {0, 1, 2}) {
            const Face next = face->neighbor(i);
            if (seen.count(next) > 0) continue;
            (triangulation.is_constrained({face, i}) ? beyond : stack).push_back(next);
        }
    }
}

/// A point in every hole: what lies beyond the outline is the domain, what lies beyond that are the holes.
std::vector<Kernel::Point_2> points_in_holes(const Triangulation& triangulation) {
    Faces seen;
    std::vector<Face> domain, holes, none;
    flood(triangulation, triangulation.infinite_face(), seen, domain);
    for (const Face face : domain)
        if (seen.count(face) == 0) flood(triangulation, face, seen, holes);
    std::vector<Kernel::Point_2> points;
    for (const Face face : holes) {
        if (seen.count(face) > 0) continue;
        points.push_back(CGAL::centroid(triangulation.triangle(face)));
        flood(triangulation, face, seen, none);
    }
    return points;
}

Triangles taken_from(const Triangulation& triangulation) {
    Triangles mesh;
    std::unordered_map<Triangulation::Vertex_handle, int, CGAL::Handle_hash_function> numbers;
    for (const Face face : triangulation.finite_face_handles()) {
        if (!face->is_in_domain()) continue;
        auto& corners = mesh.corners.emplace_back();
        for (const int i : {0, 1, 2}) {
            const auto vertex = face->vertex(i);
            const auto [number, fresh] = numbers.try_emplace(vertex, static_cast<int>(mesh.points.size()));
            if (fresh) mesh.points.emplace_back(vertex->point().x(), vertex->point().y());
            corners[static_cast<std::size_t>(i)] = number->second;
        }
    }
    return mesh;
}

void mark_domain(const Triangulation& triangulation) {
    Faces outside, inside;
    std::vector<Face> starts, none;
    flood(triangulation, triangulation.infinite_face(), outside, starts);
    for (const Face face : starts)
        if (outside.count(face) == 0) flood(triangulation, face, inside, none);
    for (const Face face : inside) face->set_in_domain(true);
}

}  // namespace

Triangles triangulate(const Polygon& domain) {
    Triangulation triangulation;
    for (const Outline& outline : domain.outlines()) add(outline, triangulation);
    mark_domain(triangulation);
    return taken_from(triangulation);
}

Triangles refine(const Polygon& domain, double size, double min_angle, int most) {
    if (!(size > 0) || !std::isfinite(size)) throw BadInput("mesh: size = " + number_text(size) + ": allowed > 0");
    if (!(min_angle >= 0 && min_angle <= largest_min_angle))
        throw BadInput("mesh: smallest angle = " + number_text(min_angle) + ": allowed 0 ... " + number_text(largest_min_angle) +
                       " degrees");
    const auto too_many = [&] {
        return BadInput("mesh: size = " + number_text(size) + " needs more than " + std::to_string(most) + " triangles");
    };
    if (!(domain.area() / size / size * 2 < most))
        throw too_many();  // an edge is at most `size`: a triangle covers less than half a square of it

    Triangulation triangulation;
    for (const Outline& outline : domain.outlines()) add(outline, triangulation);
    const auto holes = points_in_holes(triangulation);
    const double sine = std::sin(min_angle * std::numbers::pi / 180);
    Mesher mesher(triangulation, Criteria(sine * sine, size));
    mesher.set_seeds(holes.begin(), holes.end());
    mesher.init();
    // A mesh of n points has at least n - 2 triangles. Points are counted already; for triangles CGAL walks around the convex hull.
    while (mesher.step_by_step_refine_mesh())
        if (triangulation.number_of_vertices() > static_cast<std::size_t>(most) + 2) throw too_many();
    Triangles mesh = taken_from(triangulation);
    if (mesh.corners.size() > static_cast<std::size_t>(most)) throw too_many();
    return mesh;
}

}  // namespace mpm
