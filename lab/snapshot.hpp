/// Snapshots of particles and nodes as CSV.
#pragma once
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include "lab/body.hpp"
#include "lab/record.hpp"

namespace mpm {

/// None, for snapshots.
struct NoRigidBodies {};

/// Position, velocity, stress and volume of every particle of the bodies (pointers to Matter), in the order of numbers. Particles {x, v} of rigid bodies follow as bodies of
/// their own, without stress and volume.
template <int D, class Bodies, class RigidBodies = NoRigidBodies>
void write_particles(const std::string& path, const Bodies& bodies, const RigidBodies& rigid = {}) {
    CsvFile file(path, D == 1 ? std::vector<std::string>{"body", "x", "v", "F", "sigma", "V"}
                              : std::vector<std::string>{"body", "x", "y", "vx", "vy", "sxx", "syy", "sxy", "J", "V"});
    double number = 0;
    std::vector<double> row;
    for (const auto& body : bodies) {
        std::vector<std::size_t> place(body->points.size());  // of each number
        for (std::size_t i = 0; i < place.size(); ++i) place[body->number(i)] = i;
        for (const std::size_t i : place) {
            const auto& p = body->points[i];
            if constexpr (D == 1) {
                const double row[]{number, p.x[0], p.v[0], p.F(0, 0), p.sigma(0, 0), p.V};
                file.row(row, std::size(row));
            } else {
                const double row[]{number, p.x[0], p.x[1], p.v[0], p.v[1], p.sigma(0, 0), p.sigma(1, 1), p.sigma(0, 1), p.V / p.V0, p.V};
                file.row(row, std::size(row));
            }
        }
        ++number;
    }
    if constexpr (D == 2 && !std::is_same_v<RigidBodies, NoRigidBodies>)
        for (const auto& body : rigid) {
            for (const auto& p : body) {
                const double row[]{number, p.x[0], p.x[1], p.v[0], p.v[1], 0, 0, 0, 1, 0};
                file.row(row, std::size(row));
            }
            ++number;
        }
}

/// Position, mass and momentum of every node.
template <int D, class Bodies> void write_nodes(const std::string& path, const Bodies& bodies) {
    CsvFile file(path, D == 1 ? std::vector<std::string>{"body", "x", "m", "mv"} : std::vector<std::string>{"body", "x", "y", "m", "mvx", "mvy"});
    double number = 0;
    for (const auto& body : bodies) {
        for (int I = 0; I < body->grid.size(); ++I) {
            const auto& node = body->grid[I];
            const Vec<D> x = body->grid.lattice().position(I);
            if constexpr (D == 1) {
                const double row[]{number, x[0], node.m, node.mv_new[0]};
                file.row(row, std::size(row));
            } else {
                const double row[]{number, x[0], x[1], node.m, node.mv_new[0], node.mv_new[1]};
                file.row(row, std::size(row));
            }
        }
        ++number;
    }
}

}  // namespace mpm
