/// A sparse linear system that is put together element by element and solved directly (Eigen, behind sparse_system.cpp).
#pragma once
#include <memory>
#include <vector>

namespace mpm {

/// Square matrix K and its solution. Elements may be of any kind and size: those of a background grid, of a finite element body attached
/// to it, or single unknowns.
class SparseSystem {
public:
    /// A symmetric matrix is factorised as L D L^T. Any other one is solved by GMRES with the factors of its symmetric part, a tenth of the
    /// cost of L U where little of it is not symmetric; where that does not converge, L U it is.
    explicit SparseSystem(bool symmetric = true);
    ~SparseSystem();
    SparseSystem(const SparseSystem&) = delete;
    SparseSystem& operator=(const SparseSystem&) = delete;

    /// `elements[e]` are the unknowns of element e, -1 for one that is held or left out. The symbolic factorisation is made anew only if
    /// they differ from those of the last call.
    void use(int unknowns, const std::vector<std::vector<int>>& elements);
    void clear();
    /// Adds an element's matrix, row by row.
    void add(int element, const double* K);
    /// Solves K x = b. False if K is singular to working precision or holds what is no number. K is factorised anew only if it has changed.
    bool solve(const std::vector<double>& b, std::vector<double>& x);

    int unknowns() const;
    long nonzeros() const;
    long analyses() const;        // symbolic factorisations so far
    long factorisations() const;  // numerical ones
    double entry(int row, int column) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace mpm
