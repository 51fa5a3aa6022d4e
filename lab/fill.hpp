/// Particle generation: where the points of a cell lie, how much of the cell each stands for, and the points of a region (review 4.1.1).
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "lab/geometry.hpp"
#include "lab/grid.hpp"

namespace mpm {

/// Points of one cell along one axis: places from its lower end and parts that sum to one, both in cells.
struct CellRule {
    std::vector<double> at, part;
    explicit CellRule(std::size_t n) : at(n), part(n) {}
};

/// The middles of n equal parts.
inline CellRule middles(int n) {
    CellRule rule(static_cast<std::size_t>(n));
    for (std::size_t q = 0; q < rule.at.size(); ++q) {
        rule.at[q] = (static_cast<double>(q) + 0.5) / n;
        rule.part[q] = 1.0 / n;
    }
    return rule;
}

/// The n Gauss-Legendre points, exact for polynomials of degree 2n - 1: zeros of the Legendre polynomial P_n by Newton's method, from
/// starts that lie nearest to theirs.
inline CellRule gauss_points(int n) {
    CellRule rule(static_cast<std::size_t>(n));
    for (std::size_t q = 0; q < rule.at.size(); ++q) {
        double z = -std::cos(std::numbers::pi * (static_cast<double>(q) + 0.75) / (n + 0.5)), slope = 1;
        for (int i = 0; i < 10; ++i) {  // doubles its digits each time, from two
            double below = 0, p = 1;    // P_(k-1), P_k at z
            for (int k = 0; k < n; ++k) {
                const double above = ((2 * k + 1) * z * p - k * below) / (k + 1);
                below = p;
                p = above;
            }
            slope = n * (z * p - below) / (z * z - 1);
            z -= p / slope;
        }
        rule.at[q] = (1 + z) / 2;
        rule.part[q] = 1 / ((1 - z * z) * slope * slope);
    }
    return rule;
}

/// By name, as `--points` calls them.
inline CellRule cell_rule(const std::string& points, int n) { return points == "gauss" ? gauss_points(n) : middles(n); }

/// The part of the cell that each point of a rule stands for: it ends where the next one's begins [cells]. Every point lies in its own
/// part; for Gauss points this is the separation theorem of Chebyshev, Markov and Stieltjes.
inline std::vector<double> part_ends(const CellRule& rule) {
    std::vector<double> ends(rule.part.size() + 1, 0);
    for (std::size_t q = 0; q < rule.part.size(); ++q) ends[q + 1] = ends[q] + rule.part[q];
    ends.back() = 1;
    return ends;
}

/// Cells begin ... end - 1 along each axis.
struct CellRange {
    std::array<int, 2> begin{}, end{};
    long size() const { return static_cast<long>(end[0] - begin[0]) * (end[1] - begin[1]); }
};

/// The cells of a lattice that a rectangle touches, from the integer coordinates of its corners (review figure 34); none where it is empty
/// or beyond the lattice.
inline CellRange cells_of(const Bounds& box, const Lattice<2>& lattice) {
    CellRange range;
    for (const int d : {0, 1}) {
        const double first = (box.low[d] - lattice.origin()[d]) * lattice.per_h()[d], n = lattice.cells(d);
        const double last = (box.high[d] - lattice.origin()[d]) * lattice.per_h()[d];
        const auto at = static_cast<std::size_t>(d);
        range.begin[at] = static_cast<int>(std::floor(std::clamp(first, 0.0, n)));
        range.end[at] = last < first || last < 0 ? range.begin[at] : static_cast<int>(std::min(std::floor(std::min(last, n)) + 1, n));
        if (range.end[at] < range.begin[at]) range.end[at] = range.begin[at];
    }
    return range;
}

/// A particle of initial volume V0 at x, at rest: m = rho V0. Fields that the scene has beside these stay as its Point has them.
template <class Point, class X> Point particle_at(const X& x, double V0, double rho) {
    Point p;
    p.x = x;
    if constexpr (requires { p.X; }) p.X = x;
    if constexpr (requires { p.V0; }) p.V0 = V0;
    if constexpr (requires { p.V; }) p.V = V0;
    p.m = rho * V0;
    return p;
}

/// Visits the points of the cells that a region's bounds touch, x fastest, all points of a cell together: `visit(x, box)`, where the box is
/// the part of the cell that the point stands for.
template <class Visit> void each_point(const Bounds& bounds, const Lattice<2>& lattice, const CellRule& rule, Visit&& visit) {
    const CellRange cells = cells_of(bounds, lattice);
    const std::vector<double> ends = part_ends(rule);
    const auto place = [&](int i, int j, double x, double y) {
        return Vec<2>(lattice.origin() + lattice.h().cwiseProduct(Vec<2>(i + x, j + y)));
    };
    for (int j = cells.begin[1]; j < cells.end[1]; ++j)
        for (int i = cells.begin[0]; i < cells.end[0]; ++i)
            for (std::size_t q = 0; q < rule.at.size(); ++q)
                for (std::size_t p = 0; p < rule.at.size(); ++p)
                    visit(place(i, j, rule.at[p], rule.at[q]),
                          Bounds{place(i, j, ends[p], ends[q]), place(i, j, ends[p + 1], ends[q + 1])});
}

/// The points of a region on a lattice, in cell order (x fastest, then y), each with its part of the cell: V0 [length^2], m = rho V0, rho
/// the mass per area. Visits only the cells that the region's bounds touch; several objects take one call each, so that n cells and m
/// objects never cost n m. What lies beyond the lattice gets no points. Total volume: see `placement_error`.
template <class Point, Region Shape>
std::vector<Point> particles_inside(const Shape& shape, const Lattice<2>& lattice, const CellRule& rule, double rho) {
    std::vector<Point> all;
    const double cell = lattice.h().prod();
    std::vector<double> V0;
    for (const double y : rule.part)
        for (const double x : rule.part) V0.push_back(x * y * cell);
    std::size_t q = 0;  // number of the point in its cell
    each_point(shape.bounds(), lattice, rule, [&](const Vec<2>& x, const Bounds&) {
        if (shape.inside(x)) all.push_back(particle_at<Point>(x, V0[q], rho));
        q = q + 1 < V0.size() ? q + 1 : 0;
    });
    return all;
}

/// A disk of particles in rings about its centre, as far apart along a ring as the rings are, about `size`: it is round where a disk of cells
/// has steps. Total volume exact.
template <class Point> std::vector<Point> rings(const Vec<2>& centre, double radius, double size, double rho) {
    std::vector<Point> all;
    const int count = std::max(1, static_cast<int>(std::lround(radius / size)));
    const double width = radius / count;
    for (int k = 0; k < count; ++k) {
        const int n = std::max(4, static_cast<int>(std::lround(2 * std::numbers::pi * (k + 0.5))));
        const double r = (k + 0.5) * width, V0 = std::numbers::pi * width * width * (2 * k + 1) / n;
        for (int i = 0; i < n; ++i) {
            const double a = 2 * std::numbers::pi * (i + 0.5) / n;
            all.push_back(particle_at<Point>(Vec<2>(centre + r * Vec<2>(std::cos(a), std::sin(a))), V0, rho));
        }
    }
    return all;
}

/// The area that a region shares with a rectangle [length^2]: exact where the region knows it (disk, ring, box), else by the middles of
/// samples x samples equal parts.
template <Region Shape> double shared_area(const Shape& shape, const Bounds& box, int samples) {
    if constexpr (OverlapRegion<Shape>) {
        return shape.overlap(box);
    } else {
        const Vec<2> size = box.high - box.low;
        long inside = 0;
        for (int j = 0; j < samples; ++j)
            for (int i = 0; i < samples; ++i)
                inside += shape.inside(box.low + size.cwiseProduct(Vec<2>(i + 0.5, j + 0.5)) / samples) ? 1 : 0;
        return size.prod() * (static_cast<double>(inside) / samples / samples);
    }
}

/// As particles_inside, but V0 is the area that the region shares with each point's box (`shared_area`): every box of which a part is
/// inside gets a particle at its point, even if that point is just outside. A sliver gives a particle of little mass.
template <class Point, Region Shape>
std::vector<Point> particles_by_share(const Shape& shape, const Lattice<2>& lattice, const CellRule& rule, double rho, int samples = 8) {
    std::vector<Point> all;
    each_point(shape.bounds(), lattice, rule, [&](const Vec<2>& x, const Bounds& box) {
        if (const double V0 = shared_area(shape, box, samples); V0 > 0) all.push_back(particle_at<Point>(x, V0, rho));
    });
    return all;
}

/// Bound on | total volume - area | [length^2] of particles_inside for a region whose boundary consists of closed curves of this total
/// length: box and region differ only at points nearer to the boundary than d, the largest distance between a point and a corner of its
/// box, and the points within d of a closed curve cover at most 2 d length + pi d^2. With samples > 0 that of particles_by_share, by
/// sampling. The typical error is far smaller: it falls as h^(3/2) for a smooth curve across the cells, the bound as h.
inline double placement_error(const Lattice<2>& lattice, const CellRule& rule, double length, int curves = 1, int samples = 0) {
    double d = 0;  // in cells
    const std::vector<double> ends = part_ends(rule);
    for (std::size_t q = 0; q < rule.at.size(); ++q)
        d = std::max(d, samples > 0 ? rule.part[q] / samples / 2 : std::max(rule.at[q] - ends[q], ends[q + 1] - rule.at[q]));
    d *= lattice.h().norm();
    return 2 * d * length + curves * std::numbers::pi * d * d;
}

}  // namespace mpm
