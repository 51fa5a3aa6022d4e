/// Corners of particle domains, shared by neighbours, as a stage between particles and grid (review appendix C): each corner's hat
/// functions are evaluated once, not once for every particle that has it.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "lab/grid.hpp"
#include "lab/memory.hpp"
#include "lab/stencil.hpp"

namespace mpm {

/// What a node type must tell to be a corner: sums(), what particles add to it (mass, momenta, forces), and fields(), what they read from
/// it (velocities): tuples of pointers to members, e.g. std::tuple(&Node::m, &Node::mv).
template <class Node>
concept CanBeCorner = requires {
    Node::sums();
    Node::fields();
};

template <int D> class Corners {
public:
    Corners() = default;
    /// Throws OutsideGrid for a corner outside.
    Corners(const Lattice<D>& lattice, std::vector<Vec<D>> places) : lattice_(lattice), x_(std::move(places)) { check(); }

    std::size_t size() const { return x_.size(); }
    const Vec<D>& operator[](std::size_t c) const { return x_[c]; }
    const Vec<D>& operator[](int c) const { return x_[static_cast<std::size_t>(c)]; }
    /// For corners that do not move with the grid; `check` afterwards.
    Vec<D>& place(std::size_t c) { return x_[c]; }

    /// Throws OutsideGrid unless every corner is inside: the sweeps trust it.
    void check() const {
        for (const Vec<D>& x : x_)
            for (int d = 0; d < D; ++d)
                if (!lattice_.holds(x[d], d)) [[unlikely]]
                    detail::outside_grid(x[d], lattice_.origin()[d], lattice_.upper()[d], d);
    }

    /// Calls visit(node number, N) for each hat function that is not zero at corner c.
    template <class Visit> void hats(std::size_t c, Visit&& visit) const {
        std::array<double, D> r;
        int first = 0;
        for (int d = 0; d < D; ++d) {
            const double xi = lattice_.in_cells(x_[c][d], d);
            const int cell = std::min(static_cast<int>(xi), lattice_.cells(d) - 1);  // the last node belongs to the last cell
            r[static_cast<std::size_t>(d)] = xi - cell;
            first += cell * (d == 0 ? 1 : lattice_.nodes(0));
        }
        if constexpr (D == 1) {
            visit(first, 1 - r[0]);
            visit(first + 1, r[0]);
        } else {
            const int above = first + lattice_.nodes(0);
            visit(first, (1 - r[0]) * (1 - r[1]));
            visit(first + 1, r[0] * (1 - r[1]));
            visit(above, (1 - r[0]) * r[1]);
            visit(above + 1, r[0] * r[1]);
        }
    }

    /// Fields of the grid at the corners; their sums become zero.
    template <class Node> void from_grid(const Grid<D, Node>& grid, std::vector<Node>& corners) const {
        static_assert(CanBeCorner<Node>, "a node must tell its sums() and fields() to be used with domains (chapters/cpdi/corners.hpp)");
        if (corners.empty()) reserve_large(corners, size());
        corners.resize(size());
        if constexpr (!requires(Node& node) { node.x; })
            if (grid.is_reset()) return std::fill(corners.begin(), corners.end(), Node{});  // its fields are zero
        for (std::size_t c = 0; c < size(); ++c) {
            Node at{};
            hats(c, [&](int I, double N) {
                const Node& node = grid[I];
                std::apply([&](auto... field) { ((at.*field += N * node.*field), ...); }, Node::fields());
            });
            corners[c] = at;
        }
    }
    /// Adds the sums of the corners to the grid.
    template <class Node> void to_grid(const std::vector<Node>& corners, Grid<D, Node>& grid) const {
        for (std::size_t c = 0; c < size(); ++c) {
            const Node& corner = corners[c];
            hats(c, [&](int I, double N) {
                Node& node = grid[I];
                std::apply([&](auto... sum) { ((node.*sum += N * corner.*sum), ...); }, Node::sums());
            });
        }
        grid.touched();
    }
    /// Moves the corners with the grid (3.38). Throws OutsideGrid.
    template <class Node> void move(const Grid<D, Node>& grid, double dt) {
        for (std::size_t c = 0; c < size(); ++c) {
            Vec<D> v = Vec<D>::Zero();
            hats(c, [&](int I, double N) { v += N * grid[I].v_new; });
            x_[c] += dt * v;
        }
        check();
    }

private:
    Lattice<D> lattice_;
    std::vector<Vec<D>> x_;
};

}  // namespace mpm
