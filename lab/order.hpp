/// Keeps the particles of a body in the order of their cells where that pays, so that neighbours in memory touch the same nodes.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "lab/memory.hpp"

namespace mpm {

/// Whether particles may change places: not those of a shape that keeps anything by number (`numbered = false` says that it does
/// not), nor those of a scene that refers to particles by number (`static constexpr bool numbered = true`).
template <class Body, class Scene>
constexpr bool may_reorder = Body::D == 2 && requires { requires !Body::Shape::numbered; } && !requires { requires Scene::numbered; };

/// Looks from time to time at how many particles lie far from their neighbour in memory, and sorts them by cell when what this wins
/// until the next look is worth the sort. Buffers are kept; the first sort makes them.
template <class Point> class CellOrder {
public:
    static constexpr long every = 20;  // steps between looks

    /// To be called before a step; returns whether it sorted the points of a Matter.
    template <class Matter> bool keep(Matter& body) { return calls_++ % every == 0 && pays(body) && sort(body); }

    /// Sorts by cell, one row of cells after the other; the particles of a cell keep their order, and their numbers (Matter::numbers) go
    /// with them. Does nothing and returns false if a particle is outside the grid: the step will say so.
    template <class Matter> [[gnu::cold]] bool sort(Matter& body) {
        const auto& lattice = body.grid.lattice();
        const std::size_t count = body.points.size();
        start_.assign(static_cast<std::size_t>(lattice.cells(0)) * static_cast<std::size_t>(lattice.cells(1)) + 1, 0);
        cell_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const Place at = place(lattice, body.points[i]);
            if (at.column < 0) return false;
            cell_[i] = static_cast<std::uint32_t>(at.row * lattice.cells(0) + at.column);
            ++start_[cell_[i] + 1];
        }
        for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
        body.number_points();
        if (points_.empty()) reserve_large(points_, count);
        points_.resize(count);
        numbers_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t to = start_[cell_[i]]++;
            points_[to] = body.points[i];
            numbers_[to] = body.numbers[i];
        }
        body.points.swap(points_);
        body.numbers.swap(numbers_);
        return true;
    }

private:
    struct Place {
        int column = -1, row = -1;  // of a cell; -1 outside
        bool beside(const Place& other) const { return std::abs(column - other.column) <= 1 && std::abs(row - other.row) <= 1; }
    };
    template <class Lattice> static Place place(const Lattice& lattice, const Point& p) {
        if (!lattice.holds(p.x[0], 0) || !lattice.holds(p.x[1], 1)) return {};
        const auto cell = [&](int axis) { return std::min(static_cast<int>(lattice.in_cells(p.x[axis], axis)), lattice.cells(axis) - 1); };
        return {cell(0), cell(1)};
    }

    /// Looks at one pair of neighbours in memory out of 17. A particle far from its neighbour costs about 10 ns a step while particles
    /// and nodes fit into a second-level cache, and 60 ns and more otherwise; a sort costs 30 to 80 ns a particle.
    template <class Matter> [[gnu::cold]] bool pays(const Matter& body) const {
        std::size_t pairs = 0, far = 0;
        for (std::size_t i = 1; i < body.points.size(); i += 17, ++pairs)
            if (!place(body.grid.lattice(), body.points[i]).beside(place(body.grid.lattice(), body.points[i - 1]))) ++far;
        const std::size_t nodes = static_cast<std::size_t>(body.grid.size());
        const std::size_t bytes = body.points.size() * sizeof(Point) + nodes * sizeof(typename Matter::Node);
        const std::size_t cost_of_far = bytes < (std::size_t{4} << 20) ? 10 : 60, cost_of_sort = 60;
        return far * cost_of_far * every > pairs * cost_of_sort;
    }

    long calls_ = 0;
    std::vector<std::uint32_t> cell_, start_, numbers_;
    std::vector<Point> points_;
};

}  // namespace mpm
