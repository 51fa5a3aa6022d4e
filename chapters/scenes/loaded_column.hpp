/// The column of resting_column.hpp for explicit schemes: the same particles, loads and state of rest, on a lattice.
#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

#include "chapters/scenes/resting_column.hpp"
#include "lab/body.hpp"
#include "lab/grid.hpp"
#include "lab/monitor.hpp"

namespace mpm {

/// Updated-Lagrangian schemes carry the load at the column's end as it is now, total-Lagrangian ones at the last node, which is there.
template <bool TotalLagrangian> struct LoadedColumn : RestingColumn {
    double damping = 0;  // local damping (review remark 19): a part of each node's force, against its velocity; no force at rest

    LoadedColumn(const RestingColumn& column, double part) : RestingColumn(column), damping(part) {}

    Lattice<1> lattice(int cells, int per_cell) const {
        const int above = TotalLagrangian ? 0 : static_cast<int>(lines(cells)[0].size()) - 1 - cells;
        return {Vec<1>(0), Vec<1>(length / cells), {cells + above}, per_cell};
    }
    template <class Body> void load(Body& body, double t) const {
        auto& grid = body.grid;
        inner_.clear();
        for (auto& node : grid) inner_.push_back(node.f[0]), node.f += node.m * body_force(t);
        const auto [particle, x, force] = tractions(body.points, t)[0];
        if constexpr (TotalLagrangian) {
            grid[grid.size() - 1].f += force;
        } else {
            auto end = body.points[particle];
            end.x = x;
            const auto& stencil = body.shape(end, particle);
            for (const auto& [node, phi, grad] : Weights{stencil, &grid[0]}) node.f += phi * force;
        }
        if (damping == 0) return;
        for (int I = 1; I < grid.size(); ++I)
            if (grid[I].mv[0] != 0) grid[I].f[0] -= std::copysign(damping * grid[I].f[0], grid[I].mv[0]);
    }
    /// Impulse and work of all that `load` added.
    template <class Bodies> Supply supply(const Bodies& bodies, double, double dt) const {
        Supply sum;
        std::size_t I = 0;
        for (const auto& node : bodies[0]->grid) sum.add(dt * (node.f[0] - inner_[I++]), 0, node.v_new[0]);
        return sum;
    }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const { (grid[0].*field)[0] = 0; }
    template <class Grid> Vec<1> held_force(const Grid& grid) const { return grid[0].f; }

    struct Observer : RestingColumn::Observer {
        explicit Observer(const LoadedColumn& c) : RestingColumn::Observer{c} {}
    };

private:
    mutable std::vector<double> inner_;  // nodal forces of the stress alone, of the last step
};

}  // namespace mpm
