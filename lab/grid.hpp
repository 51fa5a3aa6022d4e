/// The background grid: `Lattice` knows where the nodes are, `Grid` keeps what one scheme stores on them.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <new>
#include <vector>

#include "lab/math.hpp"
#include "lab/memory.hpp"
#include "lab/threads.hpp"

namespace mpm {

/// Where the nodes of a rectangular grid are. Small: shape functions hold a copy.
template <int D> class Lattice {
public:
    /// `origin` is the lower corner [length], `h` the cell size along each axis [length], `cells` the number of cells along each axis,
    /// `per_cell` the nodes per cell and axis: 1, or 2 for quadratic Bernstein functions. Throws std::bad_alloc where an int cannot number
    /// the nodes.
    Lattice(const Vec<D>& origin, const Vec<D>& h, const std::array<int, D>& cells, int per_cell = 1)
        : origin_(origin), h_(h), per_h_(h.cwiseInverse()), cells_(cells), per_cell_(per_cell) {
        double size = 1;
        for (int d = 0; d < D; ++d) {
            upper_[d] = origin[d] + h[d] * this->cells(d);
            nodes_[at(d)] = this->cells(d) * per_cell + 1;
            size *= nodes_[at(d)];
        }
        if (size > std::numeric_limits<int>::max()) throw std::bad_alloc();
    }
    Lattice() : Lattice(Vec<D>::Zero(), Vec<D>::Ones(), {}) {}

    const Vec<D>& origin() const { return origin_; }
    const Vec<D>& upper() const { return upper_; }  // upper corner
    const Vec<D>& h() const { return h_; }
    const Vec<D>& per_h() const { return per_h_; }  // 1/h
    int per_cell() const { return per_cell_; }
    const std::array<int, D>& cells() const { return cells_; }
    int cells(int axis) const { return cells_[at(axis)]; }
    int nodes(int axis) const { return nodes_[at(axis)]; }

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
        for (int d = 0; d < D; ++d) x[d] = origin_[d] + h_[d] / per_cell_ * along(I, d);
        return x;
    }

    /// Whether x lies between the lower and the upper end of an axis; not if it is no number.
    bool holds(double x, int axis) const { return x >= origin_[axis] && x <= upper_[axis]; }
    /// x along an axis in cells from the lower corner, at most `cells`: rounding takes nobody past the upper corner.
    double in_cells(double x, int axis) const { return std::min((x - origin_[axis]) * per_h_[axis], static_cast<double>(cells(axis))); }

private:
    static std::size_t at(int axis) { return static_cast<std::size_t>(axis); }

    Vec<D> origin_, upper_ = Vec<D>::Zero(), h_, per_h_;
    std::array<int, D> cells_, nodes_{};
    int per_cell_;
};

template <int D, class NodeType> class Grid;
template <int D, class Node, class Visit> void each(Grid<D, Node>& grid, Visit&& visit);

/// The nodes of one scheme on a lattice. `NodeType` has `void reset()`; one that has a member `x` is told its position.
template <int D, class NodeType> class Grid {
public:
    using Node = NodeType;

    explicit Grid(const Lattice<D>& where = {}) : lattice_(where) {
        reserve_large(nodes_, static_cast<std::size_t>(where.size()));
        nodes_.resize(static_cast<std::size_t>(where.size()));
        if constexpr (requires(Node& n) { n.x; })
            for (int I = 0; I < where.size(); ++I) (*this)[I].x = where.position(I);
    }

    const Lattice<D>& lattice() const { return lattice_; }
    void reset() {
        each(*this, [](Node& node) { node.reset(); });
        reset_ = true;
    }
    /// Whether nothing was added to the nodes since the last reset. Those who read nodes through corners of domains ask, and tell.
    bool is_reset() const { return reset_; }
    void touched() { reset_ = false; }

    /// Threads for the sweeps over this grid's nodes and its body's particles, in two dimensions. One, unless told otherwise.
    void use_threads(int threads) { threads_ = D == 2 ? threads : 1; }
    int threads() const { return threads_; }

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
    int threads_ = 1;
    bool reset_ = false;
};

/// Visits every node, each on its own: `each(body.grid, [&](auto& node) {...})`. In as many threads as the grid was given.
template <int D, class Node, class Visit> void each(Grid<D, Node>& grid, Visit&& visit) {
    Node* const nodes = &grid[0];
    in_ranges(grid.threads(), static_cast<std::size_t>(grid.size()), [&](std::size_t I) { visit(nodes[I]); });
}

}  // namespace mpm
