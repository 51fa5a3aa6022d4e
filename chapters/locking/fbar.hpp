/// F-bar against volumetric locking (review 5.2, Algorithm 7; line numbers in the margin): the stress comes from F with its volume change
/// replaced by the mean of the particles in its cell.
///
/// In plane strain F-bar has a stretch across the plane, too: (J0/J)^(1/3) of (5.15) is one of all three axes. Without it the law would
/// find the volume change (J0/J)^(2/3) J.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "chapters/material/across.hpp"
#include "lab/body.hpp"
#include "lab/threads.hpp"

namespace mpm {

/// Given to laws in place of the velocity gradient: one that reads it does not depend on F alone and does not compile.
struct NoVelocityGradient {};

/// Which particles share their volume change.
///
/// The printed cells are those of the grid, with the particles that lie in them now. A particle that crosses into another cell then takes
/// on the volume change of its new neighbours from one step to the next, and they a part of its own: with lambda/mu in the hundreds these
/// jumps of J0 are jumps of pressure that drown the pressure itself and feed energy into the body. Particles that lay in one cell at the
/// start stay together instead, as in total-Lagrangian schemes: as many constraints a cell, and no jumps. Only where neighbours part for
/// good (fluids) the printed cells are the only ones.
enum class FbarCells { moving, grid, none };

/// The law `Law` on F-bar. For laws whose stress depends on F (and F33) alone. Without cells every F is left as it is, for comparison.
template <class Law> struct Fbar : Law {
    static constexpr const char* name = "f-bar";
    static constexpr std::array<const char*, 1> columns{"J_bar"};  // of snapshots
    template <class Base> struct PointOf : WithHistory<Law, Base>::Point {
        double F33 = 1;  // (J0/J)^(1/3) [-]: F-bar = F33 F, and the stretch across the plane
    };
    FbarCells cells = FbarCells::moving;

    /// By name: "moving", "grid"; any other for none.
    void average(const std::string& over) {
        cells = over == "moving" ? FbarCells::moving : over == "grid" ? FbarCells::grid : FbarCells::none;
    }

    /// Nothing while the scheme goes through the particles: `update_together` follows.
    template <class Point, class Gradient> void update(Point&, const Gradient&, double) const {}

    template <class Body> void update_together(Body& body) {
        const auto& lattice = body.grid.lattice();
        const bool on = cells != FbarCells::none, at_start = Body::Shape::total_lagrangian || cells == FbarCells::moving;
        std::size_t number = on ? 1 : 0;
        for (int d = 0; d < Body::D; ++d) number *= static_cast<std::size_t>(lattice.cells(d));
        sums_.assign(number, {});
        cell_of_.resize(body.points.size());
        for (std::size_t i = 0; on && i < body.points.size(); ++i) {                      // 1
            const auto& p = body.points[i];
            cell_of_[i] = cell_at(lattice, at_start ? p.X : p.x);                         // 3
            if (cell_of_[i] == outside) continue;
            sums_[cell_of_[i]].V0 += p.V0;                                                // 4
            sums_[cell_of_[i]].V += p.V0 * p.F.determinant();                             // 5
        }
        in_ranges(body.grid.threads(), body.points.size(), [&](std::size_t i) {           // 8
            auto& p = body.points[i];
            const auto F = p.F;
            if (on && cell_of_[i] != outside) {
                const double J0 = sums_[cell_of_[i]].V / sums_[cell_of_[i]].V0;           // 7, 11
                p.F33 = std::cbrt(J0 / F.determinant());                                  // 9
            }
            p.F *= p.F33;                                                                 // 12
            Law::update(p, NoVelocityGradient{}, 0);
            p.F = F;
        });
    }

    template <class Point> double energy(const Point& p) const { return Law::energy(barred(p)); }
    template <class Point>
    requires requires(const Law& law, const Point& p) { law.sigma_zz(p); }
    double sigma_zz(const Point& p) const { return Law::sigma_zz(barred(p)); }
    template <class Point> std::array<double, 1> values(const Point& p) const { return {volume_ratio(barred(p))}; }

private:
    static constexpr std::size_t outside = static_cast<std::size_t>(-1);
    struct Sums {
        double V0 = 0, V = 0;  // cellVol0, cellVol
    };
    std::vector<Sums> sums_{};
    std::vector<std::size_t> cell_of_{};  // each particle

    /// A particle that has left the grid has no cell; the next step will say so.
    template <int D> static std::size_t cell_at(const Lattice<D>& lattice, const Vec<D>& x) {
        std::size_t cell = 0;
        for (int d = D - 1; d >= 0; --d) {
            if (!lattice.holds(x[d], d)) return outside;
            const int along = std::min(static_cast<int>(lattice.in_cells(x[d], d)), lattice.cells(d) - 1);
            cell = cell * static_cast<std::size_t>(lattice.cells(d)) + static_cast<std::size_t>(along);
        }
        return cell;
    }
    template <class Point> static Point barred(Point p) {
        p.F *= p.F33;
        return p;
    }
};

}  // namespace mpm
