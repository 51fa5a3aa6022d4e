/// Prescribed velocities on grid nodes, body forces, and the scene that has neither.
#pragma once
#include <vector>

#include "lab/body.hpp"
#include "lab/grid.hpp"

namespace mpm {

/// One component of one node's velocity, held at a value.
struct FixedNode {
    int node, axis;
    double v = 0;  // velocity [length/time]
};

/// Dirichlet conditions (review 4.2.1): a list of held velocity components.
struct Dirichlet {
    std::vector<FixedNode> held;

    /// Sets the momentum `field` of the held nodes, e.g. `&Node::mv`.
    template <class Grid, class Field> void apply(Grid& grid, Field field) const {
        for (const auto& [I, axis, v] : held) (grid[I].*field)[axis] = grid[I].m * v;
    }

    /// Holds a component on every node of a grid line (in 1D: a node) at place `along` on `axis`, and on all that lie beyond it at the grid's end.
    template <int D> void hold_plane(const Lattice<D>& lattice, int axis, double x, bool beyond_is_below, int component, double v = 0) {
        const double eps = 1e-9 * lattice.h()[axis];
        for (int I = 0; I < lattice.size(); ++I) {
            const double xi = lattice.position(I)[axis];
            if (beyond_is_below ? xi <= x + eps : xi >= x - eps) held.push_back({I, component, v});
        }
    }
};

/// No load, nothing held; and a coupling that does nothing.
struct FreeScene {
    template <class Body> void load(Body&, double) const {}
    template <class Grid, class Field> void fix(Grid&, Field, double) const {}
};
struct Free {
    template <class Bodies> void operator()(Bodies&, double) const {}
};

}  // namespace mpm
