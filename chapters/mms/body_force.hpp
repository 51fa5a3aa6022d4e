/// The body force of a manufactured motion as a scheme's load, and what it brings into the balances of momentum and energy.
#pragma once
#include <array>
#include <cstddef>
#include <string>

#include "lab/body.hpp"
#include "lab/math.hpp"
#include "lab/monitor.hpp"

namespace mpm {

/// A motion tells b(X, t), the body force per mass on the material that started from X, and X_of(x, t), where the material at x started.
/// Total-Lagrangian grids do not move with the material: a node's place is its start.
struct BodyForce {
    std::string at = "particles";  // where it acts: m_p b(X_p) mapped to the nodes, or "nodes": m_I b(X_I)

    /// Adds `part` of the force at t to the nodes.
    template <bool TotalLagrangian, class Body, class Motion> void load(Body& body, const Motion& motion, double t, double part = 1) const {
        if (at == "particles") {
            scatter(body, [&](const auto& p, const auto& weights) {
                const auto f = (part * p.m * motion.b(p.X, t)).eval();
                for (const auto& [node, phi, grad] : weights) node.f += phi * f;
            });
        } else {
            auto& grid = body.grid;
            for (int I = 0; I < grid.size(); ++I)
                if (grid[I].m > 0) grid[I].f += part * grid[I].m * at_node<TotalLagrangian>(motion, grid.lattice().position(I), t);
        }
    }

    /// Impulse and work over the step from t, with the velocities after it. A leapfrog's work is the force at t times the mean of the
    /// velocities half a step before and after; summed over the steps that is the velocity times the mean of the forces at t and t + dt.
    /// (The sum begins with half of the first force: a first step with part 1/2 leaves nothing over.)
    template <bool TotalLagrangian, class Bodies, class Motion>
    Supply supply(const Bodies& bodies, const Motion& motion, double t, double dt, double part = 1) const {
        Supply sum;
        const auto add = [&](double m, const auto& mv, const auto& b_now, const auto& b_next) {
            for (int d = 0; d < b_now.size(); ++d) sum.impulse[static_cast<std::size_t>(d)] += dt * part * m * b_now[d];
            sum.work += dt * mv.dot(b_now + b_next) / 2;
        };
        for (const auto* body : bodies) {
            const auto& grid = body->grid;
            if (at == "particles") {
                for (const auto& p : body->points) add(p.m, (p.m * p.v).eval(), motion.b(p.X, t), motion.b(p.X, t + dt));
            } else {
                for (int I = 0; I < grid.size(); ++I) {
                    if (!(grid[I].m > 0)) continue;
                    const auto x = grid.lattice().position(I);
                    add(grid[I].m, grid[I].mv_new, at_node<TotalLagrangian>(motion, x, t), at_node<TotalLagrangian>(motion, x, t + dt));
                }
            }
        }
        return sum;
    }

private:
    /// The force per mass on the material at a node's place x.
    template <bool TotalLagrangian, class Motion, class Place> static Place at_node(const Motion& motion, const Place& x, double t) {
        return motion.b(TotalLagrangian ? x : motion.X_of(x, t), t);
    }
};

}  // namespace mpm
