/// Areas of gaps and overlaps between particle domains (review figure 25), exact but for rounding.
#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

#include "chapters/cpdi/domain.hpp"
#include "lab/covered_area.hpp"
#include "lab/snapshot.hpp"
#include "lab/triangles.hpp"

namespace mpm {

using Corners2 = std::vector<Vec<2>>;  // of one polygon, in order

struct Gaps {
    double gap = 0, overlap = 0;  // [length^2]
};

/// What the domains of a mesh's cells, moved to `now`, do not cover of the body and what they cover more than once. Where neighbours'
/// copies of a corner have parted, the body's corner is their mean: domains that share their corners have neither gaps nor overlaps.
inline Gaps gaps_between(const PolygonCells& mesh, const std::vector<Corners2>& now) {
    std::vector<Vec<2>> sum(mesh.points.size(), Vec<2>::Zero());
    std::vector<int> copies(mesh.points.size());
    double each = 0;
    for (std::size_t i = 0; i < now.size(); ++i)
        for (std::size_t c = 0; c < now[i].size(); ++c) {
            const auto point = static_cast<std::size_t>(mesh.corners[i][c]);
            sum[point] += now[i][c], ++copies[point];
            each += 0.5 * cross(now[i][c] - now[i][0], now[i][(c + 1) % now[i].size()] - now[i][0]);
        }
    const double covered = covered_area(now);
    bool parted = false;
    for (std::size_t i = 0; i < now.size() && !parted; ++i)
        for (std::size_t c = 0; c < now[i].size(); ++c) {
            const auto point = static_cast<std::size_t>(mesh.corners[i][c]);
            parted = parted || (sum[point] / copies[point] - now[i][c]).squaredNorm() > 1e-24 * std::abs(each);
        }
    if (!parted) return {0, each - covered};
    std::vector<Corners2> both = now;
    for (const std::vector<int>& cell : mesh.corners) {
        both.emplace_back();
        for (const int c : cell) both.back().push_back(sum[static_cast<std::size_t>(c)] / copies[static_cast<std::size_t>(c)]);
    }
    return {covered_area(both) - covered, each - covered};
}

/// The domains of a snapshot (lab/columns.hpp), in the order of their particles.
inline std::vector<Corners2> polygons_of(const Snapshot& corners) {
    const std::size_t particle = corners.find("particle"), x = corners.find("x"), y = corners.find("y");
    std::vector<Corners2> all;
    for (std::size_t row = 0; row < corners.rows(); ++row) {
        if (static_cast<std::size_t>(corners.at(row, particle)) >= all.size()) all.emplace_back();
        all.back().emplace_back(corners.at(row, x), corners.at(row, y));
    }
    return all;
}

}  // namespace mpm
