/// The background grid: `Lattice` knows where the nodes are, `Grid` keeps what one scheme stores on them.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "lab/math.hpp"

namespace mpm {

/// Where the nodes of a rectangular grid are. Small: shape functions hold a copy.
template <int D> struct Lattice {
    Vec<D> origin = Vec<D>::Zero();  // lower corner [length]
    Vec<D> h = Vec<D>::Ones();       // cell size along each axis [length]
    std::array<int, D> cells{};      // number of cells along each axis [-]
    int per_cell = 1;                // nodes per cell and axis [-]: 1, or 2 for quadratic Bernstein functions

    int nodes(int axis) const { return cells[static_cast<std::size_t>(axis)] * per_cell + 1; }

    int size() const {
        int n = 1;
        for (int d = 0; d < D; ++d) n *= nodes(d);
        return n;
    }

    /// Number of node I's neighbour along an axis, counted from I: nodes run fastest along the first axis.
    int stride(int axis) const {
        int s = 1;
        for (int d = 0; d < axis; ++d) s *= nodes(d);
        return s;
    }

    /// Place of node I along an axis, counted from the lower corner.
    int along(int I, int axis) const { return I / stride(axis) % nodes(axis); }

    Vec<D> position(int I) const {
        Vec<D> x;
        for (int d = 0; d < D; ++d) x[d] = origin[d] + h[d] / per_cell * along(I, d);
        return x;
    }

    /// x along an axis in cells from the lower corner.
    double in_cells(double x, int axis) const { return (x - origin[axis]) / h[axis]; }

    double upper(int axis) const { return origin[axis] + h[axis] * cells[static_cast<std::size_t>(axis)]; }
};

/// The nodes of one scheme on a lattice. `NodeType` has `void reset()`; one that has a member `x` is told its position.
template <int D, class NodeType> class Grid {
public:
    using Node = NodeType;

    explicit Grid(const Lattice<D>& where = {}) : lattice_(where), nodes_(static_cast<std::size_t>(where.size())) {
        if constexpr (requires(Node& n) { n.x; })
            for (int I = 0; I < where.size(); ++I) (*this)[I].x = where.position(I);
    }

    const Lattice<D>& lattice() const { return lattice_; }
    void reset() {
        for (Node& node : nodes_) node.reset();
    }

    Node& operator[](int I) { return nodes_[static_cast<std::size_t>(I)]; }
    const Node& operator[](int I) const { return nodes_[static_cast<std::size_t>(I)]; }
    auto begin() { return nodes_.begin(); }
    auto end() { return nodes_.end(); }
    auto begin() const { return nodes_.begin(); }
    auto end() const { return nodes_.end(); }
    int size() const { return static_cast<int>(nodes_.size()); }

private:
    Lattice<D> lattice_;
    std::vector<Node> nodes_;
};

}  // namespace mpm
