#include "lab/mass_matrix.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cstddef>

namespace mpm {

using Sparse = Eigen::SparseMatrix<double>;

struct MassMatrix::Impl {
    struct System {
        std::vector<bool> held;
        Sparse to_held;  // columns of held nodes in rows of free ones
        Eigen::SimplicialLDLT<Sparse> factors;
    };
    std::vector<std::unique_ptr<System>> systems;
};

void MassMatrix::factor(int nodes, const std::vector<Entry>& entries, const std::vector<std::vector<bool>>& held) {
    auto impl = std::make_shared<Impl>();
    std::vector<Eigen::Triplet<double>> free, coupling;
    for (const std::vector<bool>& is_held : held) {
        free.clear();
        coupling.clear();
        for (const Entry& e : entries) {
            if (is_held[static_cast<std::size_t>(e.row)]) continue;
            (is_held[static_cast<std::size_t>(e.column)] ? coupling : free).emplace_back(e.row, e.column, e.m);
        }
        for (int I = 0; I < nodes; ++I)
            if (is_held[static_cast<std::size_t>(I)]) free.emplace_back(I, I, 1.0);
        auto system = std::make_unique<Impl::System>();
        system->held = is_held;
        system->to_held.resize(nodes, nodes);
        system->to_held.setFromTriplets(coupling.begin(), coupling.end());
        Sparse A(nodes, nodes);
        A.setFromTriplets(free.begin(), free.end());
        system->factors.compute(A);
        impl->systems.push_back(std::move(system));
    }
    impl_ = std::move(impl);
}

void MassMatrix::solve(int c, std::vector<double>& values) const {
    const Impl::System& system = *impl_->systems[static_cast<std::size_t>(c)];
    Eigen::Map<Eigen::VectorXd> x(values.data(), static_cast<Eigen::Index>(values.size()));
    const Eigen::VectorXd right = x - system.to_held * x;
    x = system.factors.solve(right);
}

}  // namespace mpm
