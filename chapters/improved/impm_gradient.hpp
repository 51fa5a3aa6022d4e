/// The velocity gradient at a particle of the improved MPM, without the jump of the hat functions' gradient at cell edges.
#pragma once
#include <cmath>

#include "lab/grid.hpp"
#include "lab/math.hpp"

namespace mpm {

/// Along an axis, (v_{i+1} - v_i)/h is the gradient in the middle of an edge between nodes, to second order. It is interpolated linearly
/// from middle to middle along the axis (in 1D from cell centre to cell centre), and across the axis as the hat functions do. Where the
/// next edge holds no material, at a surface or the end of the grid, it is extrapolated from the one on the other side. Inside a body the
/// weights are those of the quadratic B-spline's gradient times a hat across. `grid` has `v_new` and `m` > 0 where material is.
template <int D, class Grid> Mat<D> gradient_between_cells(const Grid& grid, const Vec<D>& x) {
    const Lattice<D>& lattice = grid.lattice();
    Vec<D> r;  // place in the cell
    std::array<int, 2> cell{};
    int first = 0;  // the cell's lower node
    for (int d = 0; d < D; ++d) {
        const double xi = lattice.in_cells(x[d], d);
        const int i = std::min(static_cast<int>(xi), lattice.cells(d) - 1);
        cell[static_cast<std::size_t>(d)] = i;
        r[d] = xi - i;
        first += i * lattice.stride(d);
    }
    Mat<D> L = Mat<D>::Zero();
    for (int axis = 0; axis < D; ++axis) {
        const int stride = lattice.stride(axis), i = cell[static_cast<std::size_t>(axis)], side = r[axis] < 0.5 ? -1 : 1;
        const double s = std::abs(r[axis] - 0.5);
        for (int k = 0; k < power(2, D - 1); ++k) {
            const int across = 1 - axis, I = first + (k == 1 ? lattice.stride(across) : 0);
            const auto difference = [&](int e) -> Vec<D> { return grid[I + (e + 1) * stride].v_new - grid[I + e * stride].v_new; };
            const auto filled = [&](int e) {
                return i + e >= 0 && i + e < lattice.cells(axis) && grid[I + e * stride].m > 0 && grid[I + (e + 1) * stride].m > 0;
            };
            const double weight = (D == 1 ? 1 : k == 1 ? r[across] : 1 - r[across]) * lattice.per_h()[axis];
            if (filled(side))
                L.col(axis) += weight * ((1 - s) * difference(0) + s * difference(side));
            else if (filled(-side))
                L.col(axis) += weight * ((1 + s) * difference(0) - s * difference(-side));
            else
                L.col(axis) += weight * difference(0);
        }
    }
    return L;
}

}  // namespace mpm
