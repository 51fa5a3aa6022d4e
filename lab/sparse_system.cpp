#include "lab/sparse_system.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mpm {

struct SparseSystem::Impl {
    using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
    using Vector = Eigen::VectorXd;

    explicit Impl(bool is_symmetric) : symmetric(is_symmetric) {}

    bool symmetric;
    Matrix K;
    std::vector<std::vector<int>> elements;
    std::vector<std::vector<int>> where;  // of an element's entries in K's values, -1 for none
    Eigen::SimplicialLDLT<Matrix, Eigen::Lower> ldlt;
    Eigen::SparseLU<Matrix> lu;
    long analyses = 0, factorisations = 0;
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
        if (symmetric) ldlt.analyzePattern(K);
        else lu.analyzePattern(K);
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
        else lu.factorize(K);
        ++factorisations;
        changed = false;
    }
    bool solve(const Vector& b, Vector& x) {
        if (changed) factorise();
        if ((symmetric ? ldlt.info() : lu.info()) != Eigen::Success) return false;
        if (symmetric) x = ldlt.solve(b);
        else x = lu.solve(b);
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
