#include "lab/voronoi_diagram.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/hilbert_sort.h>

#include <numeric>

#include "lab/options.hpp"
#include "lab/record.hpp"

namespace mpm {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Storage = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>,
                                                     CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, Storage>;

/// Four seeds so far from the bounds that no point there is nearest to one of them.
void add_far_seeds(const Bounds& bounds, std::vector<Vec<2>>& seeds) {
    const Vec<2> centre = (bounds.low + bounds.high) / 2;
    const double away = 4 * (bounds.high - bounds.low).sum();
    for (const double x : {-away, away})
        for (const double y : {-away, away}) seeds.push_back(centre + Vec<2>(x, y));
}

std::vector<Delaunay::Vertex_handle> insert(const std::vector<Vec<2>>& seeds, Delaunay& triangulation) {
    std::vector<Delaunay::Vertex_handle> handles;
    handles.reserve(seeds.size());
    Delaunay::Face_handle near{};
    for (const Vec<2>& x : seeds) {
        const auto vertex = triangulation.insert({x[0], x[1]}, near);
        if (triangulation.number_of_vertices() == handles.size())
            throw BadInput("voronoi: two seeds at (" + number_text(x[0]) + ", " + number_text(x[1]) + ")");
        vertex->info() = static_cast<int>(handles.size());
        handles.push_back(vertex);
        near = vertex->face();
    }
    return handles;
}

/// Circumcentre, from differences: no digits are lost far from the origin.
Vec<2> centre_of(const Delaunay::Face_handle& face, const std::vector<Vec<2>>& seeds) {
    const auto seed = [&](int k) -> const Vec<2>& { return seeds[static_cast<std::size_t>(face->vertex(k)->info())]; };
    const Vec<2> a = seed(1) - seed(0), b = seed(2) - seed(0);
    const double aa = a.squaredNorm(), bb = b.squaredNorm(), twice = 2 * (a[0] * b[1] - a[1] * b[0]);
    return seed(0) + Vec<2>(b[1] * aa - a[1] * bb, a[0] * bb - b[0] * aa) / twice;
}

/// Sets of numbers that grow together; the smallest stands for its set.
class Sets {
public:
    explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
    int of(int i) {
        while (at(i) != i) i = at(i) = at(at(i));
        return i;
    }
    void join(int i, int j) {
        i = of(i), j = of(j);
        at(std::max(i, j)) = std::min(i, j);
    }

private:
    int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }
    std::vector<int> parent_;
};

void merge_vertices(double merge, VoronoiDiagram& diagram) {
    Sets sets(diagram.vertices.size());
    bool any = false;
    for (int i = 0; i + 1 < static_cast<int>(diagram.first.size()); ++i)
        for (int k = 0; k < diagram.count(i); ++k) {
            const int a = diagram.edge(i, k).from, b = diagram.edge(i, k + 1).from;
            if ((diagram.vertex(a) - diagram.vertex(b)).squaredNorm() >= merge * merge) continue;
            sets.join(a, b);
            any = true;
        }
    if (any)
        for (VoronoiEdge& edge : diagram.edges) edge.from = sets.of(edge.from);
}

}  // namespace

VoronoiDiagram voronoi_diagram(const std::vector<Vec<2>>& seeds, const Bounds& bounds, double merge) {
    VoronoiDiagram diagram;
    diagram.seeds = seeds;
    add_far_seeds(bounds, diagram.seeds);
    Delaunay triangulation;
    const auto handles = insert(diagram.seeds, triangulation);
    for (const auto face : triangulation.finite_face_handles()) {
        face->info() = static_cast<int>(diagram.vertices.size());
        diagram.vertices.push_back(centre_of(face, diagram.seeds));
    }
    diagram.edges.reserve(6 * seeds.size());
    for (std::size_t i = 0; i < diagram.seeds.size(); ++i) {
        diagram.first.push_back(diagram.edges.size());
        if (i >= seeds.size()) continue;
        auto face = triangulation.incident_faces(handles[i]);
        const auto start = face;
        do {
            const int own = face->index(handles[i]);
            diagram.edges.push_back({face->info(), face->vertex(Delaunay::cw(own))->info()});
        } while (++face != start);
    }
    diagram.first.push_back(diagram.edges.size());
    merge_vertices(merge, diagram);
    return diagram;
}

int VoronoiDiagram::nearest(const Vec<2>& x, int start) const {
    int best = start;
    double distance = (seed(best) - x).squaredNorm();
    for (bool nearer = true; nearer;) {  // of all seeds only the nearest has no neighbour that is nearer
        nearer = false;
        for (int k = 0, here = best; k < count(here); ++k) {
            const int other = edge(here, k).beyond;
            const double to_other = (seed(other) - x).squaredNorm();
            if (!(to_other < distance)) continue;
            best = other, distance = to_other, nearer = true;
        }
    }
    return best;
}

void along_a_curve(std::vector<Vec<2>>& points) {
    std::vector<std::pair<Kernel::Point_2, std::size_t>> sorted;
    for (const Vec<2>& x : points) sorted.emplace_back(Kernel::Point_2(x[0], x[1]), sorted.size());
    struct Traits {
        using Point_2 = std::pair<Kernel::Point_2, std::size_t>;
        struct Less_x_2 {
            bool operator()(const Point_2& a, const Point_2& b) const { return a.first.x() < b.first.x(); }
        };
        struct Less_y_2 {
            bool operator()(const Point_2& a, const Point_2& b) const { return a.first.y() < b.first.y(); }
        };
        Less_x_2 less_x_2_object() const { return {}; }
        Less_y_2 less_y_2_object() const { return {}; }
    };
    CGAL::hilbert_sort(sorted.begin(), sorted.end(), Traits());
    const std::vector<Vec<2>> before = points;
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = before[sorted[i].second];
}

}  // namespace mpm
