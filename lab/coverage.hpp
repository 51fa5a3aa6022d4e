/// Two watches over the grid: cells inside a body that no particle covers (numerical fracture), and nodes with hardly any mass.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <sstream>
#include <vector>

#include "lab/body.hpp"
#include "lab/monitor.hpp"

namespace mpm {

/// Numerical fracture (review 2.5.5): particles have moved so far apart that no node feels both sides of a gap, while their F says that the
/// material is still whole. A particle covers its own cell and every cell whose middle lies in its deformed domain, widened by a quarter
/// of a cell. A gap is a run of uncovered cells, between covered ones along every axis, at least as wide as the weighting function's
/// reach, `support - 1`. Gaps that were there at the start (holes) do not count.
template <int D> class Coverage {
public:
    template <class Matter> Coverage(const Matter& body, int support) : lattice_(body.grid.lattice()), least_(support - 1) {
        covered_.resize(static_cast<std::size_t>(cells()));
        at_start_ = count(body);
    }

    template <class Matter> Trouble check(const Matter& body) {
        const int gaps = count(body);
        if (gaps <= at_start_) return {};
        std::ostringstream s;
        s << "a gap in the body beside x = " << gap_.transpose() << ": " << gaps - at_start_ << " cell" << (gaps - at_start_ > 1 ? "s" : "")
          << " inside it without a particle";
        return {"numerical-fracture", s.str()};
    }

private:
    int cells() const {
        int n = 1;
        for (int d = 0; d < D; ++d) n *= lattice_.cells(d);
        return n;
    }
    int stride(int axis) const { return axis == 0 ? 1 : lattice_.cells(0); }
    int along(int cell, int axis) const { return cell / stride(axis) % lattice_.cells(axis); }
    bool covered(int cell) const { return covered_[static_cast<std::size_t>(cell)] != 0; }

    template <class Point> void cover(const Point& p) {
        std::array<int, 2> low{}, high{};
        const double size = std::pow(p.V0, 1.0 / D);
        for (int d = 0; d < D; ++d) {
            if (!lattice_.holds(p.x[d], d)) return;  // not a number, or outside: the next step says so
            const auto axis = static_cast<std::size_t>(d);
            const double xi = lattice_.in_cells(p.x[d], d),
                         half = 0.5 * size * p.F.row(d).template lpNorm<1>() * lattice_.per_h()[d] + 0.25;
            const double last = lattice_.cells(d) - 1, own = std::clamp(std::floor(xi), 0.0, last);
            low[axis] = static_cast<int>(std::clamp(std::ceil(xi - half - 0.5), 0.0, own));
            high[axis] = static_cast<int>(std::clamp(std::floor(xi + half - 0.5), own, last));
        }
        for (int j = low[1]; j <= high[1]; ++j)
            for (int i = low[0]; i <= high[0]; ++i) covered_[static_cast<std::size_t>(j * lattice_.cells(0) + i)] = 1;
    }

    /// Length of the run of uncovered cells through `cell` along an axis; 0 if it has no covered cell at both ends nearby.
    int run(int cell, int axis) const {
        const int place = along(cell, axis), step = stride(axis), far = 3 * least_;
        int below = 1, above = 1;
        while (below <= far && below <= place && !covered(cell - below * step)) ++below;
        while (above <= far && place + above < lattice_.cells(axis) && !covered(cell + above * step)) ++above;
        const bool closed = below <= far && below <= place && above <= far && place + above < lattice_.cells(axis);
        return closed ? below + above - 1 : 0;
    }

    template <class Matter> int count(const Matter& body) {
        std::fill(covered_.begin(), covered_.end(), char{0});
        for (const auto& p : body.points) cover(p);
        int gaps = 0;
        for (int cell = 0; cell < cells(); ++cell) {
            if (covered(cell)) continue;
            int least = run(cell, 0);
            if constexpr (D == 2) least = std::min(least, run(cell, 1));
            if (least < least_) continue;
            ++gaps;
            for (int d = 0; d < D; ++d) gap_[d] = lattice_.origin()[d] + (along(cell, d) + 0.5) * lattice_.h()[d];
        }
        return gaps;
    }

    Lattice<D> lattice_;
    int least_;  // cells
    std::vector<char> covered_;
    int at_start_ = 0;
    Vec<D> gap_ = Vec<D>::Zero();
};

/// A node inside a body that has next to no mass, between neighbours along an axis that have: too few particles in a cell, or at the wrong
/// places, for the weighting function. Forces act on it that nothing resists; what the run then gives looks like a result. Said of
/// total-Lagrangian grids, whose masses stay; a node at the end of a body may have as little as it likes.
template <int D, class Matter> Trouble massless_node(const Matter& body, double tiny) {
    const Lattice<D>& lattice = body.grid.lattice();
    double mass = 0;  // of a particle
    for (const auto& p : body.points) mass += p.m / static_cast<double>(body.points.size());
    const auto has = [&](int I) { return body.grid[I].m > 0.1 * mass; };
    for (int I = 0; I < lattice.size(); ++I)
        for (int d = 0; d < D && !(body.grid[I].m > tiny * mass); ++d) {
            const int place = lattice.along(I, d), step = lattice.stride(d);
            if (place == 0 || place == lattice.nodes(d) - 1 || !has(I - step) || !has(I + step)) continue;
            std::ostringstream s;
            s << "node " << I << " at x = " << lattice.position(I).transpose() << ", inside a body, has " << body.grid[I].m / mass
              << " of a particle's mass: too few particles for the weighting function, or all of them at its zeros";
            return {"massless-node", s.str()};
        }
    return {};
}

/// Counts what is legal but should be rare: nodes whose mass is a tiny part of a particle's (review figure 10), and, where the scheme has a
/// mass cut-off, nodes that it left out.
class NodeWatch {
public:
    template <class Matter> void look(const Matter& body, double cutoff) {
        if (body.points.empty()) return;
        const double mass = body.points.front().m;
        const auto nodes = body.grid.begin();
        const auto count = [&](std::size_t first, std::size_t last, NodeWatch& into) {
            for (std::size_t I = first; I < last; ++I) into.count(nodes[static_cast<std::ptrdiff_t>(I)].m, mass, cutoff);
        };
        const auto size = static_cast<std::size_t>(body.grid.size()), parts = static_cast<std::size_t>(body.grid.threads());
        if (parts == 1) return count(0, size, *this);
        std::mutex adding;
        in_threads(body.grid.threads(), [&](int k) {
            const auto part = static_cast<std::size_t>(k);
            NodeWatch own;
            count(size * part / parts, size * (part + 1) / parts, own);
            const std::lock_guard lock(adding);
            smallest = std::min(smallest, own.smallest);
            tiny_nodes += own.tiny_nodes;
            cut_nodes += own.cut_nodes;
        });
    }
    static constexpr double tiny = 1e-6;
    double smallest = 1;                 // nodal mass / particle mass
    long tiny_nodes = 0, cut_nodes = 0;  // node steps

private:
    void count(double m, double mass, double cutoff) {
        if (!(m > 0)) return;
        smallest = std::min(smallest, m / mass);
        if (m < tiny * mass) ++tiny_nodes;
        if (m <= cutoff) ++cut_nodes;
    }
};

}  // namespace mpm
