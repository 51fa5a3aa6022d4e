#include "lab/plane_graph.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace mpm {
namespace {

struct Spoke {
    int origin;
    double angle;
    int half;
};

/// Half-edges by origin and, around it, counter-clockwise.
std::vector<Spoke> spokes_of(const std::vector<Vec<2>>& points, const std::vector<GraphEdge>& edges) {
    std::vector<Spoke> spokes;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto [a, b] = edges[e];
        const Vec<2> d = points[static_cast<std::size_t>(b)] - points[static_cast<std::size_t>(a)];
        spokes.push_back({a, std::atan2(d[1], d[0]), static_cast<int>(2 * e)});
        spokes.push_back({b, std::atan2(-d[1], -d[0]), static_cast<int>(2 * e + 1)});
    }
    std::sort(spokes.begin(), spokes.end(),
              [](const Spoke& s, const Spoke& t) { return std::tie(s.origin, s.angle, s.half) < std::tie(t.origin, t.angle, t.half); });
    return spokes;
}

}  // namespace

FaceLoops trace_faces(const std::vector<Vec<2>>& points, const std::vector<GraphEdge>& edges) {
    const std::vector<Spoke> spokes = spokes_of(points, edges);
    std::vector<int> before(spokes.size());  // the half-edge clockwise of each around its origin
    for (std::size_t i = 0; i < spokes.size();) {
        std::size_t end = i;
        while (end < spokes.size() && spokes[end].origin == spokes[i].origin) ++end;
        for (std::size_t k = i; k < end; ++k) before[static_cast<std::size_t>(spokes[k].half)] = spokes[k == i ? end - 1 : k - 1].half;
        i = end;
    }
    FaceLoops faces{{}, std::vector<int>(spokes.size(), -1)};
    for (int start = 0; start < static_cast<int>(spokes.size()); ++start) {
        if (faces.loop_of[static_cast<std::size_t>(start)] >= 0) continue;
        auto& loop = faces.loops.emplace_back();
        for (int half = start; faces.loop_of[static_cast<std::size_t>(half)] < 0; half = before[static_cast<std::size_t>(half ^ 1)]) {
            faces.loop_of[static_cast<std::size_t>(half)] = static_cast<int>(faces.loops.size()) - 1;
            loop.push_back(half);
        }
    }
    return faces;
}

}  // namespace mpm
