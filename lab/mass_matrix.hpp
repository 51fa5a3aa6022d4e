/// The consistent mass matrix of a grid and its solution, with held nodes taken out. Eigen's sparse headers stay behind the .cpp.
#pragma once
#include <memory>
#include <vector>

namespace mpm {

/// Symmetric and positive definite on the nodes that are not held, or its solutions are not numbers.
class MassMatrix {
public:
    struct Entry {
        int row, column;
        double m;  // [mass]; entries at one place add up
    };
    /// One factored system for each list in `held`: a node with held[c][I] true keeps the value it is given.
    void factor(int nodes, const std::vector<Entry>& entries, const std::vector<std::vector<bool>>& held);
    bool empty() const { return !impl_; }

    /// Solves system c. In: momenta of the free nodes and velocities of the held ones. Out: velocities.
    void solve(int c, std::vector<double>& values) const;

private:
    struct Impl;
    std::shared_ptr<const Impl> impl_;
};

}  // namespace mpm
