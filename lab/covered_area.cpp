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
using Polygons = std::vector<std::vector<Vec<2>>>;
using Range = std::pair<double, double>;  // of y

std::vector<PlaneEdge> plane_edges(const Polygons& polygons, const std::vector<std::size_t>& which) {
    std::vector<PlaneEdge> edges;
    for (const std::size_t i : which)
        for (std::size_t c = 0; c < polygons[i].size(); ++c) {
            Vec<2> a = polygons[i][c], b = polygons[i][(c + 1) % polygons[i].size()];
            if (a[0] > b[0]) std::swap(a, b);
            if (a[0] < b[0]) edges.push_back({a, b, i});
        }
    std::sort(edges.begin(), edges.end(), [](const PlaneEdge& a, const PlaneEdge& b) { return a.left[0] < b.left[0]; });
    return edges;
}
/// Where corners are and edges cross each other or an end of the band: between two such places every edge is a straight line that meets
/// none of them.
std::vector<double> event_places(const std::vector<PlaneEdge>& edges, const Range& band) {
    std::vector<double> at;
    const auto meet = [&](double x1, double d1, double x2, double d2) {
        if (d1 * d2 < 0) at.push_back(x1 + d1 / (d1 - d2) * (x2 - x1));
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const PlaneEdge& a = edges[i];
        at.insert(at.end(), {a.left[0], a.right[0]});
        for (const double y : {band.first, band.second}) meet(a.left[0], a.left[1] - y, a.right[0], a.right[1] - y);
        for (std::size_t k = i + 1; k < edges.size() && edges[k].left[0] < a.right[0]; ++k) {
            const double x1 = edges[k].left[0], x2 = std::min(a.right[0], edges[k].right[0]);
            meet(x1, a.y(x1) - edges[k].y(x1), x2, a.y(x2) - edges[k].y(x2));
        }
    }
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    return at;
}

/// What some of the polygons cover of a band of the plane.
double covered_area(const Polygons& polygons, const std::vector<std::size_t>& which, const Range& band) {
    const std::vector<PlaneEdge> edges = plane_edges(polygons, which);
    const std::vector<double> at = event_places(edges, band);
    std::vector<const PlaneEdge*> active;
    std::vector<std::pair<std::size_t, double>> crossings;  // polygon, y
    std::vector<Range> spans;
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
        double top = band.first, length = 0;
        for (const auto& [low, high] : spans) {
            length += std::max(0.0, std::min(high, band.second) - std::max(low, top));
            top = std::max(top, high);
        }
        area += length * (at[slab + 1] - at[slab]);
    }
    return area;
}

Range range_of(const std::vector<Vec<2>>& polygon) {
    Range all{HUGE_VAL, -HUGE_VAL};
    for (const Vec<2>& corner : polygon) all = {std::min(all.first, corner[1]), std::max(all.second, corner[1])};
    return all;
}

}  // namespace

double covered_area(const Polygons& polygons) {
    std::vector<Range> ranges;
    Range all{HUGE_VAL, -HUGE_VAL};
    double heights = 0;
    for (const auto& polygon : polygons) {
        ranges.push_back(range_of(polygon));
        all = {std::min(all.first, ranges.back().first), std::max(all.second, ranges.back().second)};
        heights += std::max(0.0, ranges.back().second - ranges.back().first);
    }
    if (!(all.second > all.first)) return 0;
    // Bands as high as two polygons are: most polygons are in one or two of them, and few of a band lie over the same x.
    const double height = all.second - all.first, count = static_cast<double>(polygons.size());
    const auto bands = static_cast<std::size_t>(std::clamp(height / (2 * heights / count), 1.0, count));
    std::vector<std::vector<std::size_t>> members(bands);
    const auto band_of = [&](double y) {
        return std::min(bands - 1, static_cast<std::size_t>((y - all.first) / height * static_cast<double>(bands)));
    };
    for (std::size_t i = 0; i < polygons.size(); ++i)
        if (!polygons[i].empty())
            for (std::size_t band = band_of(ranges[i].first); band <= band_of(ranges[i].second); ++band) members[band].push_back(i);
    const auto line = [&](std::size_t band) {
        return band == bands ? all.second : all.first + height * static_cast<double>(band) / static_cast<double>(bands);
    };
    double area = 0;
    for (std::size_t band = 0; band < bands; ++band) area += covered_area(polygons, members[band], {line(band), line(band + 1)});
    return area;
}

}  // namespace mpm
