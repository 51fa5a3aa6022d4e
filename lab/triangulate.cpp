#include "lab/triangulate.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <utility>

namespace mpm {

std::vector<Triangle> triangulate(const std::vector<std::array<double, 2>>& points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
    using Structure = CGAL::Triangulation_data_structure_2<Vertex>;
    std::vector<std::pair<Kernel::Point_2, std::size_t>> numbered;
    for (const auto& [x, y] : points) numbered.emplace_back(Kernel::Point_2(x, y), numbered.size());
    const CGAL::Delaunay_triangulation_2<Kernel, Structure> delaunay(numbered.begin(), numbered.end());
    std::vector<Triangle> triangles;
    for (const auto& face : delaunay.finite_face_handles())
        triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    return triangles;
}

}  // namespace mpm
