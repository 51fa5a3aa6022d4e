/// The points of every cell of a square grid, and how much of a little box lies in a ring.
#pragma once
#include <cstddef>
#include <vector>

#include "lab/fill.hpp"
#include "lab/grid.hpp"

namespace mpm {

/// A rectangle by its middle and its sides [length].
struct Box {
    Vec<2> middle, sides;
    double volume() const { return sides[0] * sides[1]; }
};

/// Calls visit(X, box) for the points of every cell, cell by cell: place, and the point's part of the cell.
template <class Visit> void for_each_cell_point(const Lattice<2>& lattice, const CellRule& rule, Visit&& visit) {
    std::vector<double> middle(rule.at.size());  // of the parts, in cells
    double edge = 0;
    for (std::size_t q = 0; q < middle.size(); ++q) {
        middle[q] = edge + rule.part[q] / 2;
        edge += rule.part[q];
    }
    const Vec<2>&h = lattice.h(), &low = lattice.origin();
    for (int j = 0; j < lattice.cells(1); ++j)
        for (int i = 0; i < lattice.cells(0); ++i)
            for (std::size_t r = 0; r < middle.size(); ++r)
                for (std::size_t q = 0; q < middle.size(); ++q) {
                    const auto place = [&](double x, double y) { return Vec<2>(low[0] + h[0] * (i + x), low[1] + h[1] * (j + y)); };
                    visit(place(rule.at[q], rule.at[r]),
                          Box{place(middle[q], middle[r]), Vec<2>(h[0] * rule.part[q], h[1] * rule.part[r])});
                }
}

/// What a ring leaves of a box: the part of its volume, and the middle of that part.
struct CutBox {
    double part;
    Vec<2> middle;
};

/// The part of a box that lies between the circles of radius R_i and R_o about the origin, by 32 x 32 samples: off by at most 1/32 of
/// the box where a straight edge runs along them, 1e-3 on average.
inline CutBox cut_by_ring(const Box& box, double R_i, double R_o) {
    constexpr int n = 32;
    const double R = box.middle.norm(), reach = box.sides.norm() / 2;
    if (R - reach >= R_i && R + reach <= R_o) return {1, box.middle};
    int inside = 0;
    Vec<2> sum = Vec<2>::Zero();
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Vec<2> off((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5), X = box.middle + box.sides.cwiseProduct(off);
            if (X.norm() < R_i || X.norm() > R_o) continue;
            ++inside;
            sum += X;
        }
    return {static_cast<double>(inside) / (n * n), inside > 0 ? Vec<2>(sum / inside) : box.middle};
}

}  // namespace mpm
