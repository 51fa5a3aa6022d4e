#include "lab/sparse_system.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <unsupported/Eigen/IterativeSolvers>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mpm {

namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
using Ldlt = Eigen::SimplicialLDLT<Matrix, Eigen::Lower>;

/// Factors as a preconditioner, in the form that Eigen's GMRES asks for.
struct Factors {
    const Ldlt* ldlt = nullptr;
    template <class Other> Factors& analyzePattern(const Other&) { return *this; }
    template <class Other> Factors& factorize(const Other&) { return *this; }
    template <class Other> Factors& compute(const Other&) { return *this; }
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return ldlt->solve(b); }
    Eigen::ComputationInfo info() { return Eigen::Success; }
};

}  // namespace

struct SparseSystem::Impl {
    using Vector = Eigen::VectorXd;

    explicit Impl(bool is_symmetric) : symmetric(is_symmetric) {}

    bool symmetric;
    Matrix K;
    std::vector<std::vector<int>> elements;
    std::vector<std::vector<int>> where;  // of an element's entries in K's values, -1 for none
    Ldlt ldlt;                    // of K, or of its symmetric part
    Eigen::SparseLU<Matrix> lu;   // only once it has been needed
    bool has_lu = false;          // of this K
    long analyses = 0, factorisations = 0;
    bool lu_knows_pattern = false;
    bool changed = true;  // since it was factorised

    void build(int unknowns) {
        std::vector<Eigen::Triplet<double>> entries;
        for (const auto& element : elements)
            for (const int i : element)
                for (const int j : element)
                    if (i >= 0 && j >= 0) entries.emplace_back(i, j, 0.0);
        K.resize(unknowns, unknowns);
        K.setFromTriplets(entries.begin(), entries.end());
        K.makeCompressed();
        where.clear();
        for (const auto& element : elements) {
            auto& places = where.emplace_back();
            for (const int i : element)
                for (const int j : element) places.push_back(i >= 0 && j >= 0 ? place(i, j) : -1);
        }
        ldlt.analyzePattern(K);
        lu_knows_pattern = false;
        ++analyses;
        changed = true;
    }
    int place(int row, int column) const {
        const int *begin = K.innerIndexPtr() + K.outerIndexPtr()[column], *end = K.innerIndexPtr() + K.outerIndexPtr()[column + 1];
        return static_cast<int>(std::lower_bound(begin, end, row) - K.innerIndexPtr());
    }

    /// Of the residual of a solution, relative to |K| |x|: beyond it the factors are worthless.
    static constexpr double worthless = 1e-6;
    void factorise() {
        if (symmetric) ldlt.factorize(K);
        else ldlt.factorize(0.5 * (K + Matrix(K.transpose())));
        ++factorisations;
        changed = has_lu = false;
    }
    /// False if GMRES does not converge.
    bool iterate(const Vector& b, Vector& x) const {
        constexpr int most = 80;
        constexpr double tolerance = 1e-13;
        if (ldlt.info() != Eigen::Success) return false;
        Eigen::GMRES<Matrix, Factors> gmres;
        gmres.preconditioner().ldlt = &ldlt;
        gmres.set_restart(most);
        gmres.setMaxIterations(most);
        gmres.setTolerance(tolerance);
        gmres.compute(K);
        x = gmres.solve(b);
        return gmres.info() == Eigen::Success && x.allFinite();
    }
    bool solve_by_lu(const Vector& b, Vector& x) {
        if (!lu_knows_pattern) lu.analyzePattern(K);
        lu_knows_pattern = true;
        if (!has_lu) lu.factorize(K), ++factorisations;
        has_lu = true;
        if (lu.info() != Eigen::Success) return false;
        x = lu.solve(b);
        return true;
    }
    bool solve(const Vector& b, Vector& x) {
        if (changed) factorise();
        if (symmetric) {
            if (ldlt.info() != Eigen::Success) return false;
            x = ldlt.solve(b);
        } else if (!iterate(b, x) && !solve_by_lu(b, x)) {
            return false;
        }
        if (!x.allFinite()) return false;
        const double left = (K * x - b).lpNorm<Eigen::Infinity>();
        double size = 0;
        for (int j = 0; j < K.outerSize(); ++j)
            for (Matrix::InnerIterator it(K, j); it; ++it) size = std::max(size, std::abs(it.value() * x[j]));
        return left <= worthless * std::max(size, b.lpNorm<Eigen::Infinity>());
    }
};

SparseSystem::SparseSystem(bool symmetric) : impl_(std::make_unique<Impl>(symmetric)) {}
SparseSystem::~SparseSystem() = default;

void SparseSystem::use(int unknowns, const std::vector<std::vector<int>>& elements) {
    if (impl_->analyses > 0 && unknowns == impl_->K.rows() && elements == impl_->elements) return;
    impl_->elements = elements;
    impl_->build(unknowns);
}
void SparseSystem::clear() {
    std::fill_n(impl_->K.valuePtr(), impl_->K.nonZeros(), 0.0);
    impl_->changed = true;
}
void SparseSystem::add(int element, const double* K) {
    for (const int place : impl_->where[static_cast<std::size_t>(element)]) {
        if (place >= 0) impl_->K.valuePtr()[place] += *K;
        ++K;
    }
    impl_->changed = true;
}
bool SparseSystem::solve(const std::vector<double>& b, std::vector<double>& x) {
    Impl::Vector solution;
    const bool well = impl_->solve(Eigen::Map<const Impl::Vector>(b.data(), static_cast<Eigen::Index>(b.size())), solution);
    x.assign(solution.data(), solution.data() + solution.size());
    return well;
}
int SparseSystem::unknowns() const { return static_cast<int>(impl_->K.rows()); }
long SparseSystem::nonzeros() const { return impl_->K.nonZeros(); }
long SparseSystem::analyses() const { return impl_->analyses; }
long SparseSystem::factorisations() const { return impl_->factorisations; }
double SparseSystem::entry(int row, int column) const { return impl_->K.coeff(row, column); }

}  // namespace mpm
