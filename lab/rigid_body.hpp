/// Moving rigid bodies, made of particles that only hold nodes (review 4.2.4, equation 4.7, lines 7, 14, 18 and 19 of Algorithm 4).
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "lab/boundary.hpp"

namespace mpm {

/// A velocity that rises smoothly from zero to v0 over the time `rise`; without it, v0 from the start (4.7).
template <int D> struct Ramp {
    Vec<D> v0 = Vec<D>::Zero();  // [length/time]
    double rise = 0;             // [time]

    Vec<D> velocity(double t) const {
        if (t >= rise) return v0;
        const double r = std::max(0.0, t / rise);
        return r * r * (3 - 2 * r) * v0;
    }
    /// The integral of the velocity.
    Vec<D> displacement(double t) const {
        if (t >= rise) return (t - rise / 2) * v0;
        const double r = std::max(0.0, t / rise);
        return rise * r * r * r * (1 - r / 2) * v0;
    }
};

/// A particle of a rigid body as a snapshot shows it.
template <int D> struct RigidPoint {
    Vec<D> x, v;  // position, velocity
};

/// A rigid body that moves by a given displacement: all nodes of the elements that contain one of its particles have its velocity.
/// Particles must lie no further apart than a cell; those outside the grid hold nothing. `Motion` has velocity(t) and displacement(t).
///
/// The body sticks to all that comes into these elements, up to a cell before it touches, and holds it also against being pulled away.
/// Smooth functions reach further than an element: `reach` more lines of nodes on each side are held too, so that all functions that a
/// point of the rigid body's elements touches are, and the velocity field is the rigid one throughout them. It is felt a cell earlier for
/// each line. A node that becomes held in a step gets the velocity by an impulse, as in a perfectly inelastic impact with a body of
/// infinite mass.
template <int D, class Motion = Ramp<D>> class RigidBody {
public:
    std::vector<Vec<D>> X;        // places of its particles at t = 0
    Motion motion{};
    int reach = 0;                // 0 for hat functions, see reach_of
    std::optional<int> normal{};  // the one component that is held, along the body all slips freely; none: all are

    RigidBody() = default;
    explicit RigidBody(std::vector<Vec<D>> places, const Motion& moves = {}) : X(std::move(places)), motion(moves) {}

    /// Lines of nodes to hold for functions that touch `support` nodes along an axis.
    static constexpr int reach_of(int support) { return (support - 1) / 2; }

    RigidPoint<D> particle(std::size_t i, double t) const { return {X[i] + motion.displacement(t), motion.velocity(t)}; }

    /// Sets the momentum `field`, e.g. `&Node::mv`, of the nodes that are held at t.
    template <class Grid, class Field> void apply(Grid& grid, Field field, double t) const {
        const Vec<D> v = motion.velocity(t);
        visit(grid.lattice(), t, [&](int I) { each_held([&](int d) { (grid[I].*field)[d] = grid[I].m * v[d]; }); });
    }

    /// Impulse and work of the body in a step, after it; `t` is that at its end. The impulse is as exact as Dirichlet::supply's.
    template <class Grid> Supply supply(const Grid& grid, double t, double dt) {
        Supply sum;
        const Vec<D> v = motion.velocity(t);
        seen_.resize(static_cast<std::size_t>(grid.size()), 0);
        visit(grid.lattice(), t, [&](int I) {
            char& seen = seen_[static_cast<std::size_t>(I)];
            if (seen == 0) each_held([&](int d) { sum.add(held_impulse(grid[I], d, v[d], dt), d, v[d]); });
            seen = 1;
        });
        visit(grid.lattice(), t, [&](int I) { seen_[static_cast<std::size_t>(I)] = 0; });
        return sum;
    }

private:
    template <class Each> void each_held(Each&& each) const {
        for (int d = 0; d < D; ++d)
            if (!normal || *normal == d) each(d);
    }

    /// Calls each(I) for the nodes held at t, for some of them several times.
    template <class Each> void visit(const Lattice<D>& lattice, double t, Each&& each) const {
        const Vec<D> moved = motion.displacement(t);
        for (const Vec<D>& X_p : X) {
            const Vec<D> x = X_p + moved;
            std::array<int, 2> low{}, high{};
            bool outside = false;
            for (int d = 0; d < D; ++d) {
                outside = outside || !lattice.holds(x[d], d);
                if (outside) break;
                const int cell = std::min(static_cast<int>(lattice.in_cells(x[d], d)), lattice.cells(d) - 1), per_cell = lattice.per_cell();
                low[static_cast<std::size_t>(d)] = std::max(cell * per_cell - reach, 0);
                high[static_cast<std::size_t>(d)] = std::min((cell + 1) * per_cell + reach, lattice.nodes(d) - 1);
            }
            if (outside) continue;
            for (int j = low[1]; j <= high[1]; ++j)
                for (int i = low[0]; i <= high[0]; ++i) each(j * lattice.nodes(0) + i);
        }
    }

    std::vector<char> seen_;  // by `supply`, of the nodes
};

}  // namespace mpm
