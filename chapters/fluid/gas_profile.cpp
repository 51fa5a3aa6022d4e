#include "chapters/fluid/gas_profile.hpp"

#include <array>
#include <cmath>

#include "lab/stencil.hpp"

namespace mpm {
namespace {

const std::array<std::string, 4> exact_columns{"rho_exact", "v_exact", "p_exact", "e_exact"};

std::array<double, 4> exact_values(const ExactTube& exact, double x, double t) {
    const GasState s = exact.at(x, t);
    return {s.rho, s.u, s.p, s.energy(exact.gamma)};
}

}  // namespace

GasState ExactTube::at(double x, double t) const {
    return solution.at(t > 0 ? (x - diaphragm) / t : x < diaphragm ? -1e300 : 1e300);
}

Snapshot with_exact(const Snapshot& particles, const ExactTube& exact, double t) {
    Snapshot s{particles.columns};
    s.columns.insert(s.columns.end(), exact_columns.begin(), exact_columns.end());
    const std::size_t n = particles.columns.size(), x = particles.find("x");
    for (std::size_t row = 0; row < particles.rows(); ++row) {
        for (std::size_t column = 0; column < n; ++column) s.values.push_back(particles.at(row, column));
        s.add(exact_values(exact, particles.at(row, x), t));
    }
    return s;
}

GridSnapshot gas_on_nodes(const Snapshot& particles, const WeightsAt& weights, const GridSnapshot& grid, const ExactTube& exact, double t) {
    const std::size_t x = particles.find("x"), v = particles.find("v"), F = particles.find("F"), V = particles.find("V"),
                      rho = particles.find("rho"), p = particles.find("p"), e = particles.find("e");
    struct Sums {
        double m = 0, V = 0, mv = 0, mp = 0, me = 0;
    };
    std::vector<Sums> nodes(static_cast<std::size_t>(grid.nodes[0]));
    const auto add = [&](std::size_t row) {
        for (const auto& [I, phi] : weights(particles.at(row, x), particles.at(row, F))) {
            Sums& node = nodes[static_cast<std::size_t>(I)];
            const double volume = phi * particles.at(row, V), m = volume * particles.at(row, rho);
            node.V += volume, node.m += m;
            node.mv += m * particles.at(row, v), node.mp += m * particles.at(row, p), node.me += m * particles.at(row, e);
        }
    };
    try {
        for (std::size_t row = 0; row < particles.rows(); ++row) add(row);
    } catch (const OutsideGrid&) {
        nodes.clear();
    }
    GridSnapshot s;
    s.columns = {"body", "x", "m", "mv", "rho", "v", "p", "e"};
    s.columns.insert(s.columns.end(), exact_columns.begin(), exact_columns.end());
    s.nodes = grid.nodes, s.origin = grid.origin, s.spacing = grid.spacing;
    for (std::size_t I = 0; I < nodes.size(); ++I) {
        const Sums& node = nodes[I];
        if (!(node.m > 0)) continue;
        const double at = grid.origin[0] + static_cast<double>(I) * grid.spacing[0];
        s.add(std::array<double, 8>{0, at, node.m, node.mv, node.m / node.V, node.mv / node.m, node.mp / node.m, node.me / node.m});
        s.add(exact_values(exact, at, t));
    }
    return s;
}

std::vector<NamedError> gas_errors(const Snapshot& rows, const std::string& weight, const std::string& suffix) {
    std::vector<NamedError> errors;
    for (const std::string name : {"rho", "v", "p", "e"}) {
        const std::size_t value = rows.find(name), exact = rows.find(name + "_exact"), w = rows.find(weight);
        double sum = 0, total = 0;
        for (std::size_t row = 0; row < rows.rows(); ++row) {
            const double part = weight.empty() ? 1 : rows.at(row, w);
            sum += part * std::abs(rows.at(row, value) - rows.at(row, exact));
            total += part;
        }
        errors.push_back({name + suffix, sum / total});
    }
    return errors;
}

}  // namespace mpm
