/// Rigid walls as partners in contact (review 5.1.5, figures 48 and 49): planes, or bodies of rigid particles, at rest or moving. A wall
/// has an infinite mass, so the centre-of-mass velocity (5.3) is its own.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "lab/rigid_body.hpp"

namespace mpm {

/// A wall. A plane's normal points out of it, into the room of the bodies; rigid particles need none. Particles should lie no further apart
/// than half a cell, so that no node beside them is missed.
template <int D> struct RigidWall {
    Vec<D> at = Vec<D>::Zero(), normal = Vec<D>::Zero();  // of a plane; the normal has length one, zero for a wall of particles
    std::vector<Vec<D>> X = {};                           // places of the particles at t = 0
    double spacing = 0;                                   // of the particles [length]
    Ramp<D> motion = {};

    bool plane() const { return X.empty(); }
    Vec<D> velocity(double t) const { return motion.velocity(t); }
    /// Distance of a place from a plane, negative inside the wall.
    double height(const Vec<D>& x, double t) const { return (x - at - motion.displacement(t)).dot(normal); }

    /// Marks the nodes that the wall reaches: those of cells that hold a particle, or a part of a plane's inside.
    void mark(const Lattice<D>& lattice, double t, std::vector<char>& marks) const {
        marks.assign(static_cast<std::size_t>(lattice.size()), 0);
        if (plane()) {
            const double reach = lattice.h().cwiseProduct(normal).template lpNorm<1>() * (1 - 1e-9);
            for (int I = 0; I < lattice.size(); ++I)
                if (height(lattice.position(I), t) < reach) marks[static_cast<std::size_t>(I)] = 1;
            return;
        }
        for (const Vec<D>& X_p : X) each_corner(lattice, X_p + motion.displacement(t), [&](int I) { marks[static_cast<std::size_t>(I)] = 1; });
    }

    /// Visits the rigid particles in the cells around a node as visit(x, gradient of the hat function).
    template <class Visit> void around(const Lattice<D>& lattice, const Vec<D>& node, double t, Visit&& visit) const {
        for (const Vec<D>& X_p : X) {
            const Vec<D> x = X_p + motion.displacement(t), r = (x - node).cwiseProduct(lattice.per_h());
            if (!((r.array().abs() < 1).all())) continue;
            Vec<D> grad;
            for (int d = 0; d < D; ++d) {
                grad[d] = (r[d] > 0 ? -1 : 1) * lattice.per_h()[d];
                for (int e = 0; e < D; ++e)
                    if (e != d) grad[d] *= 1 - std::abs(r[e]);
            }
            visit(x, grad);
        }
    }

private:
    template <class Each> static void each_corner(const Lattice<D>& lattice, const Vec<D>& x, Each&& each) {
        std::array<int, 2> cell{};
        for (int d = 0; d < D; ++d) {
            if (!lattice.holds(x[d], d)) return;
            cell[static_cast<std::size_t>(d)] = std::min(static_cast<int>(lattice.in_cells(x[d], d)), lattice.cells(d) - 1);
        }
        for (int j = cell[1]; j <= cell[1] + (D == 2 ? 1 : 0); ++j)
            for (int i = cell[0]; i <= cell[0] + 1; ++i) each(j * lattice.nodes(0) + i);
    }
};

}  // namespace mpm
