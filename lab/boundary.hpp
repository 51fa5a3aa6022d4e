/// Conditions on grid nodes: prescribed velocities, planes of symmetry; and the scene that has none. Moving rigid bodies:
/// lab/rigid_body.hpp, tractions: lab/traction.hpp.
#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "lab/body.hpp"
#include "lab/grid.hpp"
#include "lab/monitor.hpp"

namespace mpm {

/// One component of one node's velocity, held at a value.
struct FixedNode {
    int node, axis;
    double v = 0;  // velocity [length/time]
};

/// Whatever can tell whether a place lies in it: the regions of lab/geometry.hpp and simpler ones.
template <class R, int D>
concept TellsInside = requires(const R& region, const Vec<D>& x) {
    { region.inside(x) } -> std::convertible_to<bool>;
};

/// What holding one velocity component gave to a node in a step: the change of its momentum that its force does not account for. `node.v`
/// is the velocity at t that the scheme took the step from, v the held one at t + dt. A node that was free at t gets its change of velocity
/// too.
template <class Node> double held_impulse(const Node& node, int axis, double v, double dt) {
    return node.m * (v - node.v[axis]) - dt * node.f[axis];
}

/// Dirichlet conditions (review 4.2.1): a list of held velocity components. Values that move in time, all with one history, are those of
/// the list times a factor; conditions with different histories are lists of their own.
struct Dirichlet {
    std::vector<FixedNode> held;  // by node and component

    /// Sets the momentum `field` of the held nodes, e.g. `&Node::mv`.
    template <class Grid, class Field> void apply(Grid& grid, Field field, double factor = 1) const {
        for (const auto& [I, axis, v] : held) (grid[I].*field)[axis] = grid[I].m * (factor * v);
    }

    /// Holds a component of a node; the last word on it counts.
    void hold(int node, int axis, double v = 0) {
        const auto before = [](const FixedNode& a, const FixedNode& b) { return std::tie(a.node, a.axis) < std::tie(b.node, b.axis); };
        const FixedNode wanted{node, axis, v};
        const auto at = std::lower_bound(held.begin(), held.end(), wanted, before);
        if (at != held.end() && !before(wanted, *at)) at->v = v;
        else held.insert(at, wanted);
    }

    /// Holds a component on every node of a grid line (in 1D: a node) at place x on `axis`, and on all that lie beyond it at the grid's
    /// end.
    template <int D> void hold_plane(const Lattice<D>& lattice, int axis, double x, bool beyond_is_below, int component, double v = 0) {
        const double eps = 1e-9 * lattice.h()[axis];
        hold_where(lattice, component, v, [&](const Vec<D>& at) { return beyond_is_below ? at[axis] <= x + eps : at[axis] >= x - eps; });
    }
    /// Holds a component on every node inside a region, or outside of it.
    template <int D, TellsInside<D> R> void hold_inside(const Lattice<D>& lattice, const R& region, int component, double v = 0) {
        hold_where(lattice, component, v, [&](const Vec<D>& at) { return region.inside(at); });
    }
    template <int D, TellsInside<D> R> void hold_outside(const Lattice<D>& lattice, const R& region, int component, double v = 0) {
        hold_where(lattice, component, v, [&](const Vec<D>& at) { return !region.inside(at); });
    }

    /// Impulse and work of the held nodes in a step, after it; `factor` is that at t + dt. Exact for momentum if particles take all of
    /// their velocities' change from the nodes (FLIP); what PIC takes besides is not known to the nodes.
    template <class Grid> Supply supply(const Grid& grid, double dt, double factor = 1) const {
        Supply sum;
        for (const auto& [I, axis, v] : held) sum.add(held_impulse(grid[I], axis, factor * v, dt), axis, factor * v);
        return sum;
    }

private:
    template <int D, class Where> void hold_where(const Lattice<D>& lattice, int component, double v, Where&& where) {
        for (int I = 0; I < lattice.size(); ++I)
            if (where(lattice.position(I))) hold(I, component, v);
    }
};

/// A plane of symmetry on a grid line, the body on one side of it: the normal velocity is zero there, the tangential one free.
///
/// Functions wider than a cell reach past the plane. There the mirror image would give its share to the first nodes on this side, and the
/// body gives as much to the first nodes beyond: both velocities are the mean, weighted by mass, of one and the other's mirror image. With
/// lumped masses the half then moves exactly as the whole does, if the grid goes on for a cell beyond the plane, so that functions there
/// are those of its inside. At the grid's end only the normal velocity is held, and folded functions let the tangential one have a slope.
/// Hat functions do not reach past the plane and need nothing.
template <int D> class SymmetryPlane {
public:
    /// Throws std::invalid_argument if x is on no grid line.
    SymmetryPlane(const Lattice<D>& lattice, int axis, double x) : axis_(axis), stride_(lattice.stride(axis)) {
        const double line = (x - lattice.origin()[axis]) * lattice.per_h()[axis] * lattice.per_cell();
        if (!(std::abs(line - std::round(line)) < 1e-9) || !lattice.holds(x, axis))
            throw std::invalid_argument("a plane of symmetry must lie on a grid line");
        const int number = static_cast<int>(std::round(line));
        at_end_ = number == 0 || number == lattice.nodes(axis) - 1;
        for (int I = 0; I < lattice.size(); ++I)
            if (lattice.along(I, axis) == number) nodes_.push_back(I);
    }

    /// Makes the velocities of the momentum `field` symmetric.
    template <class Grid, class Field> void apply(Grid& grid, Field field) const {
        for (const int I : nodes_) {
            (grid[I].*field)[axis_] = 0;
            if (at_end_) continue;
            auto &above = grid[I + stride_], &below = grid[I - stride_];
            if (!(above.m > 0 && below.m > 0)) continue;
            const Vec<D> v = (above.*field + mirrored(below.*field)) / (above.m + below.m);
            above.*field = above.m * v;
            below.*field = below.m * mirrored(v);
        }
    }

    /// Sum of the nodal forces that the plane bears: minus its force on the body, which is normal to it.
    template <class Grid> Vec<D> held_force(const Grid& grid) const {
        Vec<D> sum = Vec<D>::Zero();
        for (const int I : nodes_) {
            sum[axis_] += grid[I].f[axis_];
            if (at_end_) continue;
            const auto &above = grid[I + stride_], &below = grid[I - stride_];
            if (!(above.m > 0 && below.m > 0)) continue;
            const double a = (above.f[axis_] - below.f[axis_]) / (above.m + below.m);
            sum[axis_] += above.f[axis_] + below.f[axis_] - (above.m - below.m) * a;
        }
        return sum;
    }

private:
    Vec<D> mirrored(Vec<D> v) const {
        v[axis_] = -v[axis_];
        return v;
    }

    int axis_, stride_;
    bool at_end_ = false;
    std::vector<int> nodes_;  // on the plane
};

/// No load, nothing held; and a coupling that does nothing. The seam `coupling` makes bodies feel each other wherever their nodal momenta
/// are final: (bodies, t, dt) after the forces; `start` after the mapping, in schemes that update stress first; `again` after a second
/// mapping, which serves the stress alone.
struct FreeScene {
    template <class Body> void load(Body&, double) const {}
    template <class Grid, class Field> void fix(Grid&, Field, double) const {}
};
struct Free {
    template <class... Any> void operator()(Any&&...) const {}
    template <class Bodies> void start(Bodies&, double, double) const {}
    template <class Bodies> void again(Bodies&, double, double) const {}
};

}  // namespace mpm
