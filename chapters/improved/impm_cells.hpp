/// The cells of the improved MPM (impm.hpp): how much of each holds material, and its quadrature points.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "chapters/improved/near_points.hpp"
#include "lab/math.hpp"
#include "lab/threads.hpp"

namespace mpm {

/// A quadrature point: the material around it.
template <int D> struct CellPoint {
    double rho = 0, V = 0;           // density; volume of material that the point stands for
    Mat<D> sigma = Mat<D>::Zero();   // Cauchy stress
};

/// Cells with one quadrature point in the middle, or 2^D Gauss points.
template <int D> class ImpmCells {
public:
    NearPoints<D> near;

    /// Finds the cells with particles. `whole`: each of them counts as full. Else those at the surface, with a cell beside them that has
    /// none, count by their particles' volumes: each a square (in 1D a line) about its particle, what reaches into a cell without
    /// particles counting for the particle's own. The grid's ends are no surface.
    template <class Points> void find(const Lattice<D>& lattice, const Points& points, bool whole, bool gauss) {
        near.fill(lattice, points);
        const auto count = static_cast<std::size_t>(near.cell_count());
        part_.assign(count, 0);
        inner_.assign(count, 0);
        for (int c = 0; c < near.cell_count(); ++c)
            if (near.count(c) > 0 && (whole || surrounded(c))) inner_[at(c)] = 1, part_[at(c)] = 1;
        if (!whole) fill_surface(points);
        samples_.resize(gauss ? power(2, D) : 1);
        for (auto& s : samples_) s.resize(count);
        const double V_cell = lattice.h().prod() / static_cast<double>(samples_.size());
        for (auto& s : samples_)
            for (std::size_t c = 0; c < count; ++c) s[c].V = part_[c] * V_cell;
    }

    /// Visits every quadrature point in a cell with material: visit(point, x).
    template <class Visit> void each_sample(int threads, Visit&& visit) {
        in_ranges(threads, part_.size(), [&](std::size_t c) {
            if (!(part_[c] > 0)) return;
            for (std::size_t k = 0; k < samples_.size(); ++k) visit(samples_[k][c], place(static_cast<int>(c), k));
        });
    }

    /// Visits the quadrature points around node I with the node's hat function there: visit(point, N, grad N).
    template <class Visit> void around(int I, Visit&& visit) const {
        const Lattice<D>& lattice = near.lattice();
        for (int corner = 0; corner < power(2, D); ++corner) {
            int c = 0;
            bool inside = true;
            for (int d = D - 1; d >= 0; --d) {
                const int i = lattice.along(I, d) - side(corner, d);
                inside = inside && i >= 0 && i < lattice.cells(d);
                c = c * lattice.cells(d) + i;
            }
            if (!inside || !(part_[at(c)] > 0)) continue;
            for (std::size_t k = 0; k < samples_.size(); ++k) {
                double N = 1;
                Vec<D> grad = Vec<D>::Ones();
                for (int d = 0; d < D; ++d) {
                    const double r = within(k, d), phi = side(corner, d) ? r : 1 - r;
                    N *= phi;
                    for (int e = 0; e < D; ++e) grad[e] *= e == d ? (side(corner, d) ? 1 : -1) * lattice.per_h()[d] : phi;
                }
                visit(samples_[k][at(c)], N, grad);
            }
        }
    }

private:
    static std::size_t at(int c) { return static_cast<std::size_t>(c); }
    static int side(int corner, int axis) { return corner >> axis & 1; }
    int stride(int axis) const { return axis == 0 ? 1 : near.lattice().cells(0); }
    int along(int cell, int axis) const { return cell / stride(axis) % near.lattice().cells(axis); }

    /// Place of quadrature point k in its cell along an axis [cells].
    double within(std::size_t k, int axis) const {
        const double off = samples_.size() == 1 ? 0 : 0.5 / std::sqrt(3.0);
        return side(static_cast<int>(k), axis) ? 0.5 + off : 0.5 - off;
    }
    Vec<D> place(int cell, std::size_t k) const {
        Vec<D> x = near.lattice().origin();
        for (int d = 0; d < D; ++d) x[d] += (along(cell, d) + within(k, d)) * near.lattice().h()[d];
        return x;
    }

    /// Visits a cell and those beside it, over its corners too.
    template <class Visit> void around_cell(int cell, Visit&& visit) const {
        const Lattice<D>& lattice = near.lattice();
        const int i = along(cell, 0), j = D == 2 ? along(cell, D - 1) : 0, rows = D == 2 ? lattice.cells(D - 1) : 1;
        for (int b = std::max(0, j - 1); b <= std::min(rows - 1, j + 1); ++b)
            for (int a = std::max(0, i - 1); a <= std::min(lattice.cells(0) - 1, i + 1); ++a) visit(b * lattice.cells(0) + a);
    }
    bool surrounded(int cell) const {
        bool all = true;
        around_cell(cell, [&](int other) { all = all && near.count(other) > 0; });
        return all;
    }
    /// The volumes of the particles that reach into cells at the surface.
    template <class Points> void fill_surface(const Points& points) {
        beside_.assign(inner_.size(), 0);
        bool any = false;
        for (int c = 0; c < near.cell_count(); ++c)
            if (near.count(c) > 0 && !inner_[at(c)]) any = true, around_cell(c, [&](int other) { beside_[at(other)] = 1; });
        if (!any) return;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (beside_[at(near.cell(i))]) add_volume(points[i], near.cell(i));
    }
    template <class Point> void add_volume(const Point& p, int own) {
        const Lattice<D>& lattice = near.lattice();
        const double length = D == 1 ? p.V : std::sqrt(p.V);
        std::array<int, 2> low{}, high{};
        std::array<double, 2> from{}, to{};
        for (int d = 0; d < D; ++d) {
            const auto axis = static_cast<std::size_t>(d);
            const double n = lattice.cells(d), middle = lattice.in_cells(p.x[d], d), half = length / 2 * lattice.per_h()[d];
            from[axis] = std::max(0.0, middle - half), to[axis] = std::min(n, middle + half);
            low[axis] = static_cast<int>(from[axis]), high[axis] = std::min(static_cast<int>(to[axis]), lattice.cells(d) - 1);
        }
        for (int j = low[1]; j <= high[1]; ++j)
            for (int i = low[0]; i <= high[0]; ++i) {
                double shared = std::min(to[0], i + 1.0) - std::max(from[0], static_cast<double>(i));
                if (D == 2) shared *= std::min(to[1], j + 1.0) - std::max(from[1], static_cast<double>(j));
                const int c = j * lattice.cells(0) + i, to_cell = near.count(c) > 0 ? c : own;
                if (!inner_[at(to_cell)]) part_[at(to_cell)] += shared;
            }
    }

    std::vector<double> part_;                          // of each cell that holds material; above 1 by what reaches beyond the surface
    std::vector<char> inner_, beside_;                  // cells that count as full; those at or beside the surface
    std::vector<std::vector<CellPoint<D>>> samples_;    // of each place in a cell, by cell
};

}  // namespace mpm
