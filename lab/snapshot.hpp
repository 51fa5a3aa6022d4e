/// Snapshots of particles and nodes as CSV.
#pragma once
#include <string>
#include <vector>

#include "lab/body.hpp"
#include "lab/record.hpp"

namespace mpm {

/// Snapshots: position, velocity, stress of every particle; position, mass, momentum of every node.
template <class Bodies> void write_particles(const std::string& path, const Bodies& bodies) {
    constexpr int D = Bodies::value_type::D;
    CsvFile file(path, D == 1 ? std::vector<std::string>{"body", "x", "v", "F", "sigma", "V"}
                              : std::vector<std::string>{"body", "x", "y", "vx", "vy", "sxx", "syy", "sxy", "J", "V"});
    for (std::size_t b = 0; b < bodies.size(); ++b)
        for (const auto& p : bodies[b].points) {
            std::vector<double> r{static_cast<double>(b)};
            if constexpr (D == 1)
                r.insert(r.end(), {p.x[0], p.v[0], p.F(0, 0), p.sigma(0, 0), p.V});
            else
                r.insert(r.end(), {p.x[0], p.x[1], p.v[0], p.v[1], p.sigma(0, 0), p.sigma(1, 1), p.sigma(0, 1), p.V / p.V0, p.V});
            file.row(r.data(), r.size());
        }
}
template <class Bodies> void write_nodes(const std::string& path, const Bodies& bodies) {
    constexpr int D = Bodies::value_type::D;
    CsvFile file(path, D == 1 ? std::vector<std::string>{"body", "x", "m", "mv"} : std::vector<std::string>{"body", "x", "y", "m", "mvx", "mvy"});
    for (std::size_t b = 0; b < bodies.size(); ++b)
        for (int I = 0; I < bodies[b].grid.size(); ++I) {
            const auto& node = bodies[b].grid[I];
            const Vec<D> x = bodies[b].grid.lattice().position(I);
            std::vector<double> r{static_cast<double>(b), x[0]};
            if constexpr (D == 2) r.push_back(x[1]);
            r.push_back(node.m);
            for (int d = 0; d < D; ++d) r.push_back(node.mv_new[d]);
            file.row(r.data(), r.size());
        }
}

}  // namespace mpm
