#include "lab/voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "lab/mesh.hpp"
#include "lab/record.hpp"
#include "lab/tidy_cells.hpp"
#include "lab/voronoi_clip.hpp"

namespace mpm {
namespace {

constexpr int most_cells = 5000000;

/// Numbers 0 ... 1, the same on every machine for one seed.
class Random {
public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}
    double operator()() { return std::ldexp(static_cast<double>(bits_() >> 11), -53); }

private:
    std::mt19937_64 bits_;
};

/// Points at random in a polygon.
class Sampler {
public:
    Sampler(const Polygon& domain, std::uint64_t seed) : mesh_(triangulate(domain)), random_(seed) {
        double sum = 0;
        for (std::size_t i = 0; i < mesh_.corners.size(); ++i) sums_.push_back(sum += cell_moments(mesh_.points, mesh_.corners[i], i).area);
    }
    /// In the k-th of n parts of the same area.
    Vec<2> point(int k, int n) {
        const double sum = sums_.back() * (k + random_()) / n;
        const auto found = std::upper_bound(sums_.begin(), sums_.end() - 1, sum);
        const auto& corners = mesh_.corners[static_cast<std::size_t>(found - sums_.begin())];
        const auto at = [&](std::size_t c) -> const Vec<2>& { return mesh_.points[static_cast<std::size_t>(corners[c])]; };
        double r = random_(), s = random_();
        if (r + s > 1) r = 1 - r, s = 1 - s;
        return at(0) + r * (at(1) - at(0)) + s * (at(2) - at(0));
    }

private:
    Triangles mesh_;
    std::vector<double> sums_;  // of areas
    Random random_;
};

double largest_coordinate(const Polygon& domain) {
    return domain.bounds().low.cwiseAbs().cwiseMax(domain.bounds().high.cwiseAbs()).maxCoeff();
}

/// What the tessellation of a domain is measured with [length].
struct Scale {
    double spacing, reach;
};
Scale scale_of(const Polygon& domain, std::size_t cells) {
    if (cells < 1 || cells > static_cast<std::size_t>(most_cells))
        throw BadInput("voronoi: " + std::to_string(cells) + " cells: allowed 1 ... " + std::to_string(most_cells));
    const double spacing = std::sqrt(domain.area() / static_cast<double>(cells));
    double shortest = Bounds::inf;
    for (const Outline& outline : domain.outlines())
        for (std::size_t k = 0; k < outline.size(); ++k)
            shortest = std::min(shortest, (outline[(k + 1) % outline.size()] - outline[k]).norm());
    const double reach = std::min(1e-7 * spacing, 1e-3 * shortest);
    const double largest = largest_coordinate(domain);
    if (!(reach > 16 * std::numeric_limits<double>::epsilon() * largest))
        throw BadInput("voronoi: " + std::to_string(cells) + " cells are too small for the digits of coordinates near " +
                       number_text(largest) + ": spacing " + number_text(spacing) + ", shortest edge of the polygon " +
                       number_text(shortest));
    return {spacing, reach};
}

ClippedCells clipped(const Polygon& domain, const std::vector<Vec<2>>& seeds, const Scale& scale) {
    return clip(voronoi_diagram(seeds, domain.bounds(), scale.reach), domain, scale.reach);
}

/// Throws BadInput where cells leave a gap or overlap by more than rounding of their corners does.
void check_area(const ClippedCells& cells, const Polygon& domain) {
    double sum = 0;
    for (std::size_t i = 0; i < cells.corners.size(); ++i) sum += cell_moments(cells.points, cells.corners[i], i).area;
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * largest_coordinate(domain) * domain.perimeter();
    if (!(std::abs(sum - domain.area()) <= 1e-12 * domain.area() + rounding))
        throw BadInput("voronoi: cells with the area " + number_text(sum) + " for a polygon of " + number_text(domain.area()) +
                       ": try another seed or number of cells");
}

PolygonCells finished(const Polygon& domain, const std::vector<Vec<2>>& seeds, const Scale& scale) {
    constexpr std::size_t most_corners = 10;
    ClippedCells cells = clipped(domain, seeds, scale);
    check_area(cells, domain);
    join_small_parts(0.25 * scale.spacing * scale.spacing, most_corners, cells);
    cut_cells(most_corners, cells);
    collapse_short_edges(0.02 * scale.spacing, cells);
    return compact(cells);
}

/// The centroid of each seed's largest part; without one it begins anew.
std::vector<Vec<2>> centroids(const ClippedCells& cells, std::size_t n, Sampler& sampler) {
    std::vector<CellMoments> largest(n);
    for (std::size_t i = 0; i < cells.corners.size(); ++i) {
        const CellMoments part = cell_moments(cells.points, cells.corners[i], i);
        CellMoments& best = largest[static_cast<std::size_t>(cells.seed[i])];
        if (part.area > best.area) best = part;
    }
    std::vector<Vec<2>> all;
    for (const CellMoments& best : largest) all.push_back(best.area > 0 ? best.centroid : sampler.point(0, 1));
    return all;
}

}  // namespace

CentroidalCells centroidal_voronoi(const Polygon& domain, long cells, const Lloyd& lloyd) {
    if (cells < 1) throw BadInput("voronoi: " + std::to_string(cells) + " cells: allowed 1 ... " + std::to_string(most_cells));
    if (lloyd.iterations < 0) throw BadInput("voronoi: " + std::to_string(lloyd.iterations) + " iterations: allowed >= 0");
    if (!(lloyd.tolerance >= 0)) throw BadInput("voronoi: tolerance = " + number_text(lloyd.tolerance) + ": allowed >= 0");
    const Scale scale = scale_of(domain, static_cast<std::size_t>(cells));
    Sampler sampler(domain, lloyd.seed);
    std::vector<Vec<2>> seeds;
    const int count = static_cast<int>(cells);  // scale_of has seen that it fits
    for (int k = 0; k < count; ++k) seeds.push_back(sampler.point(k, count));
    along_a_curve(seeds);

    CentroidalCells result;
    result.moved = Bounds::inf;
    while (result.iterations < lloyd.iterations && result.moved > lloyd.tolerance) {
        const auto next = centroids(clipped(domain, seeds, scale), seeds.size(), sampler);
        double longest = 0;
        for (std::size_t i = 0; i < seeds.size(); ++i) longest = std::max(longest, (next[i] - seeds[i]).norm());
        result.moved = longest / scale.spacing;
        seeds = next;
        ++result.iterations;
    }
    result.cells = finished(domain, seeds, scale);
    return result;
}

PolygonCells voronoi(const Polygon& domain, std::vector<Vec<2>> seeds) {
    const Scale scale = scale_of(domain, seeds.size());
    const Bounds bounds = domain.bounds();
    for (const Vec<2>& x : seeds)
        if (!((x.array() >= bounds.low.array()).all() && (x.array() <= bounds.high.array()).all()))
            throw BadInput("voronoi: the seed (" + number_text(x[0]) + ", " + number_text(x[1]) + ") is out of the polygon's bounds");
    along_a_curve(seeds);
    return finished(domain, seeds, scale);
}

}  // namespace mpm
