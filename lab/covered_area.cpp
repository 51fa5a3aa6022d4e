#include "lab/covered_area.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace mpm {
namespace {

struct PlaneEdge {
    Vec<2> left, right;  // by x; not upright
    std::size_t polygon;
    double y(double x) const { return left[1] + (x - left[0]) / (right[0] - left[0]) * (right[1] - left[1]); }
};
std::vector<PlaneEdge> plane_edges(const std::vector<std::vector<Vec<2>>>& polygons) {
    std::vector<PlaneEdge> edges;
    for (std::size_t i = 0; i < polygons.size(); ++i)
        for (std::size_t c = 0; c < polygons[i].size(); ++c) {
            Vec<2> a = polygons[i][c], b = polygons[i][(c + 1) % polygons[i].size()];
            if (a[0] > b[0]) std::swap(a, b);
            if (a[0] < b[0]) edges.push_back({a, b, i});
        }
    std::sort(edges.begin(), edges.end(), [](const PlaneEdge& a, const PlaneEdge& b) { return a.left[0] < b.left[0]; });
    return edges;
}
/// Where corners are and edges cross: between two such places every edge is a straight line that meets no other.
std::vector<double> event_places(const std::vector<PlaneEdge>& edges) {
    std::vector<double> at;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const PlaneEdge& a = edges[i];
        at.insert(at.end(), {a.left[0], a.right[0]});
        for (std::size_t k = i + 1; k < edges.size() && edges[k].left[0] < a.right[0]; ++k) {
            const PlaneEdge& b = edges[k];
            const double x1 = b.left[0], x2 = std::min(a.right[0], b.right[0]), d1 = a.y(x1) - b.y(x1), d2 = a.y(x2) - b.y(x2);
            if (d1 * d2 < 0) at.push_back(x1 + d1 / (d1 - d2) * (x2 - x1));
        }
    }
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    return at;
}

}  // namespace

double covered_area(const std::vector<std::vector<Vec<2>>>& polygons) {
    const std::vector<PlaneEdge> edges = plane_edges(polygons);
    const std::vector<double> at = event_places(edges);
    std::vector<const PlaneEdge*> active;
    std::vector<std::pair<std::size_t, double>> crossings;     // polygon, y
    std::vector<std::pair<double, double>> spans;
    std::size_t next = 0;
    double area = 0;
    for (std::size_t slab = 0; slab + 1 < at.size(); ++slab) {
        while (next < edges.size() && edges[next].left[0] <= at[slab]) active.push_back(&edges[next++]);
        std::erase_if(active, [&](const PlaneEdge* e) { return e->right[0] <= at[slab]; });
        const double x = 0.5 * (at[slab] + at[slab + 1]);
        crossings.clear(), spans.clear();
        for (const PlaneEdge* e : active) crossings.emplace_back(e->polygon, e->y(x));
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) spans.emplace_back(crossings[k].second, crossings[k + 1].second);
        std::sort(spans.begin(), spans.end());
        double top = -HUGE_VAL, length = 0;
        for (const auto& [low, high] : spans) {
            length += std::max(0.0, high - std::max(low, top));
            top = std::max(top, high);
        }
        area += length * (at[slab + 1] - at[slab]);
    }
    return area;
}

}  // namespace mpm
