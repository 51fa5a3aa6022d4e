/// What particles and a finite element body exchange through the nodes they share.
#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

#include "lab/math.hpp"

namespace mpm {

template <int D> struct Exchange {
    Vec<D> on_body = Vec<D>::Zero(), on_particles = Vec<D>::Zero();  // forces in the last step
    double impulse = 0, unbalanced = 0;  // sums of |impulse| at the nodes, and of what both sides do not agree on

    /// Residuals of both sides by component and node: at a shared node a side's residual is the force that the other one exerts on it.
    /// Nodes that are held or that no particle reaches do not count.
    void add(const std::vector<double>& of_particles, const std::vector<double>& of_body, const std::vector<int>& number,
             const std::vector<char>& is_body_node, double dt) {
        on_body = on_particles = Vec<D>::Zero();
        for (std::size_t i = 0; i < number.size(); ++i) {
            if (!is_body_node[i / D] || number[i] < 0 || of_particles[i] == 0) continue;
            on_particles[static_cast<Eigen::Index>(i % D)] += of_particles[i];
            on_body[static_cast<Eigen::Index>(i % D)] += of_body[i];
            impulse += dt * std::abs(of_particles[i]);
            unbalanced += dt * std::abs(of_particles[i] + of_body[i]);
        }
    }
    double imbalance() const { return impulse > 0 ? unbalanced / impulse : 0; }
};

}  // namespace mpm
