/// What the scenes of liquids share: the liquid as the command line says it, and gravity on the grid.
#pragma once
#include "chapters/fluid/newtonian.hpp"
#include "lab/monitor.hpp"
#include "lab/options.hpp"

namespace mpm {

/// A liquid: water, but for a bulk modulus that makes steps 40 times as long and keeps the density within 3 % (review 5.4.1).
struct LiquidSettings {
    double kappa = 1.2e6, gamma = 7, rho = 1000, mu = 1e-3, zeta = 0;

    void declare(Options& o) {
        o.number("kappa", kappa, "stress", above(0), "bulk modulus of the equation of state");
        o.number("gamma", gamma, "-", {.low = 1, .high = 100, .low_open = true}, "exponent of the equation of state: 7 water, 1.4 air");
        o.number("rho", rho, "mass/volume", above(0), "density at rest");
        o.number("mu", mu, "stress time", at_least(0), "shear viscosity");
        o.number("zeta", zeta, "stress time", at_least(0), "bulk viscosity, lambda_N + 2/3 mu_N; 0: Stokes' condition");
    }
    Newtonian liquid() const { return {kappa, gamma, rho, mu, zeta}; }
};

/// Velocity of a node that moves particles: in MUSL that before the second mapping.
template <class Node> const auto& moving_velocity(const Node& node) {
    if constexpr (requires { node.v_tilde; }) return node.v_tilde;
    else return node.v_new;
}

/// A constant acceleration on every node, and what it supplies in a step: its work is what particles lose in potential energy.
template <int D> struct Gravity {
    Vec<D> g = Vec<D>::Zero();  // [length/time^2]

    template <class Grid> void load(Grid& grid) const {
        each(grid, [this](auto& node) { node.f += node.m * g; });
    }
    template <class Grid> Supply supply(const Grid& grid, double dt) const {
        Supply sum;
        for (const auto& node : grid)
            for (int d = 0; d < D; ++d) sum.add(dt * node.m * g[d], d, moving_velocity(node)[d]);
        return sum;
    }
};

}  // namespace mpm
