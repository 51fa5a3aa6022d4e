/// Structured meshes of boxes and rings, and quadrilaterals made of triangles: cells counter-clockwise that share their corners, without
/// CGAL. Lengths in any consistent units; cells as in lab/triangles.hpp, whose areas and particles serve them too.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "lab/geometry.hpp"
#include "lab/math.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"
#include "lab/triangles.hpp"

namespace mpm {

struct Quadrilaterals {
    std::vector<Vec<2>> points;               // [length]
    std::vector<std::array<int, 4>> corners;  // numbers of points, counter-clockwise
};

/// Cells of a structured mesh in its two directions: to the right and up, or outward and around.
struct CellCounts {
    int first = 1, second = 1;
    long all() const { return static_cast<long>(first) * second; }
};

/// Which diagonal cuts the cells of a box: from the lower left corner in all, or that and the other by turns as on a chess board.
enum class Diagonals { rising, alternating };

namespace detail {

inline constexpr int most_structured = 5000000;  // cells; as many as lab/mesh.hpp makes

inline void check_counts(const CellCounts& n) {
    if (n.first < 1 || n.second < 1 || n.first > most_structured / n.second)
        throw BadInput("mesh: " + std::to_string(n.first) + " x " + std::to_string(n.second) + " cells: allowed 1 ... " +
                       std::to_string(most_structured) + " in all");
}

inline void check_box(const Box& box) {
    if (!box.low.allFinite() || !box.high.allFinite() || !((box.high - box.low).array() > 0).all())
        throw BadInput("mesh: the box from (" + number_text(box.low[0]) + ", " + number_text(box.low[1]) + ") to (" +
                       number_text(box.high[0]) + ", " + number_text(box.high[1]) + ") has no area");
}

inline void check_ring(const Ring& ring, double from, double to) {
    if (!ring.centre.allFinite() || !(ring.inner > 0) || !(ring.outer > ring.inner) || !std::isfinite(ring.outer))
        throw BadInput("mesh: ring between the radii " + number_text(ring.inner) + " and " + number_text(ring.outer) +
                       ": allowed 0 < inner < outer");
    if (!std::isfinite(from) || !(to > from) || !(to - from <= 2 * std::numbers::pi))
        throw BadInput("mesh: sector from " + number_text(from) + " to " + number_text(to) + ": allowed 0 < to - from <= 2 pi");
}

/// (cos, sin), exact at whole quarters of a turn: a quarter ring ends on the axes.
inline Vec<2> direction(double angle) {
    const double quarters = std::nearbyint(angle / (std::numbers::pi / 2)), rest = angle - quarters * (std::numbers::pi / 2);
    const double c = std::cos(rest), s = std::sin(rest);
    const std::array<Vec<2>, 4> turned{Vec<2>(c, s), Vec<2>(-s, c), Vec<2>(-c, -s), Vec<2>(s, -c)};
    return turned[static_cast<std::size_t>(std::fmod(quarters, 4) + 4) % 4];
}

/// The cells of a lattice whose points are numbered along the first direction first; in a closed one the last row of points is the first.
inline std::vector<std::array<int, 4>> lattice_cells(const CellCounts& n, bool closed) {
    std::vector<std::array<int, 4>> cells;
    cells.reserve(static_cast<std::size_t>(n.first) * static_cast<std::size_t>(n.second));
    const int row = n.first + 1;
    for (int j = 0; j < n.second; ++j)
        for (int i = 0; i < n.first; ++i) {
            const int low = i + j * row, high = closed && j + 1 == n.second ? i : low + row;
            cells.push_back({low, low + 1, high + 1, high});
        }
    return cells;
}

}  // namespace detail

/// n.first x n.second equal cells. Throws BadInput for a box without area, for fewer than one cell and for more than 5e6.
inline Quadrilaterals quadrilaterals_of(const Box& box, const CellCounts& n) {
    detail::check_box(box);
    detail::check_counts(n);
    Quadrilaterals mesh{{}, detail::lattice_cells(n, false)};
    for (int j = 0; j <= n.second; ++j)
        for (int i = 0; i <= n.first; ++i) {
            const double r = double(i) / n.first, s = double(j) / n.second;  // both ends are met exactly
            mesh.points.emplace_back((1 - r) * box.low[0] + r * box.high[0], (1 - s) * box.low[1] + s * box.high[1]);
        }
    return mesh;
}

/// The part of a ring from angle `from` to `to` [radian], n.first cells outward and n.second around, with corners on the circles: its area
/// is that of the polygon between them. A whole turn is closed: the last cells share the corners of the first. Throws BadInput as for a
/// box, and unless 0 < inner < outer and 0 < to - from <= 2 pi; a whole ring has at least three cells around.
inline Quadrilaterals quadrilaterals_of(const Ring& ring, const CellCounts& n, double from = 0, double to = 2 * std::numbers::pi) {
    detail::check_ring(ring, from, to);
    detail::check_counts(n);
    const bool closed = to - from == 2 * std::numbers::pi;
    if (n.second * std::numbers::pi <= to - from)
        throw BadInput("mesh: " + std::to_string(n.second) + " cells around: a cell must span less than half a turn");
    Quadrilaterals mesh{{}, detail::lattice_cells(n, closed)};
    for (int j = 0; j < n.second + (closed ? 0 : 1); ++j) {
        const double t = double(j) / n.second;
        const Vec<2> e = detail::direction((1 - t) * from + t * to);
        for (int i = 0; i <= n.first; ++i) {
            const double r = double(i) / n.first;
            mesh.points.push_back(ring.centre + ((1 - r) * ring.inner + r * ring.outer) * e);
        }
    }
    return mesh;
}

/// Three quadrilaterals in each triangle: its centroid, the middles of two edges, the corner between them. Neighbours share the middles.
/// Throws BadInput as cell_moments does.
inline Quadrilaterals quadrilaterals_of(const Triangles& triangles) {
    Quadrilaterals mesh{triangles.points, {}};
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
        const auto [at, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.points.size()));
        if (fresh)
            mesh.points.push_back((triangles.points[static_cast<std::size_t>(a)] + triangles.points[static_cast<std::size_t>(b)]) / 2);
        return at->second;
    };
    for (std::size_t number = 0; number < triangles.corners.size(); ++number) {
        auto [a, b, c] = triangles.corners[number];
        const Vec<2> centroid = cell_moments(triangles.points, triangles.corners[number], number).centroid;
        const auto x = [&](int corner) -> const Vec<2>& { return triangles.points[static_cast<std::size_t>(corner)]; };
        if ((x(b)[0] - x(a)[0]) * (x(c)[1] - x(a)[1]) < (x(b)[1] - x(a)[1]) * (x(c)[0] - x(a)[0])) std::swap(b, c);
        const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a), inner = static_cast<int>(mesh.points.size());
        mesh.points.push_back(centroid);
        mesh.corners.insert(mesh.corners.end(), {{a, ab, inner, ca}, {b, bc, inner, ab}, {c, ca, inner, bc}});
    }
    return mesh;
}

/// Two triangles in each cell of a structured mesh that has n.first x n.second of them.
inline Triangles triangles_of(const Quadrilaterals& cells, const CellCounts& n, Diagonals diagonals = Diagonals::rising) {
    Triangles mesh{cells.points, {}};
    for (std::size_t k = 0; k < cells.corners.size(); ++k) {
        const auto [a, b, c, d] = cells.corners[k];
        const auto column = k % static_cast<std::size_t>(n.first), row = k / static_cast<std::size_t>(n.first);
        if (diagonals == Diagonals::rising || (column + row) % 2 == 0)
            mesh.corners.insert(mesh.corners.end(), {{a, b, c}, {a, c, d}});
        else
            mesh.corners.insert(mesh.corners.end(), {{a, b, d}, {b, c, d}});
    }
    return mesh;
}

/// Two triangles in each of n.first x n.second equal cells of a box. Throws BadInput as quadrilaterals_of does.
inline Triangles triangles_of(const Box& box, const CellCounts& n, Diagonals diagonals = Diagonals::rising) {
    return triangles_of(quadrilaterals_of(box, n), n, diagonals);
}

}  // namespace mpm
