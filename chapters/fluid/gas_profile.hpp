/// Density, velocity, pressure and internal energy of a gas in a tube, at its particles and mapped to the nodes, beside the exact solution.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "chapters/fluid/riemann.hpp"
#include "lab/norms.hpp"
#include "lab/snapshot.hpp"

namespace mpm {

/// A node and its weight for a particle.
struct NodeWeight {
    int node;
    double phi;
};
/// The weights of a particle at x [length] with the deformation F, by the weighting function of the run.
using WeightsAt = std::function<std::vector<NodeWeight>(double x, double F)>;

/// Where the exact solution stands at one time.
struct ExactTube {
    Riemann solution;
    double diaphragm, gamma;  // [length], [-]
    GasState at(double x, double t) const;  // t = 0: the state at the start
};

/// The snapshot of the particles with `rho_exact, v_exact, p_exact, e_exact`.
Snapshot with_exact(const Snapshot& particles, const ExactTube& exact, double t);

/// The nodes with the columns x, m, mv, rho, v, p, e and the exact values. Velocity, pressure and energy are mapped with the particles'
/// masses (review 6.1.4), the density is mass over mapped volume. Nodes without mass are left out, and all of them while a particle is
/// outside the grid or too long for its weighting function.
GridSnapshot gas_on_nodes(const Snapshot& particles, const WeightsAt& weights, const GridSnapshot& grid, const ExactTube& exact, double t);

/// Mean absolute differences over the length of the tube, L1: rho, v, p, e, with `suffix` behind their names. `weight` is the column that
/// a row counts by; "" for all alike.
std::vector<NamedError> gas_errors(const Snapshot& rows, const std::string& weight, const std::string& suffix);

}  // namespace mpm
