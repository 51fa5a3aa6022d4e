/// Small fixed-size vectors and matrices, D = 1 included, so that one text serves one and two dimensions.
#pragma once
#include <Eigen/Core>
#include <Eigen/LU>

namespace mpm {

template <int D> using Vec = Eigen::Matrix<double, D, 1>;
template <int D> using Mat = Eigen::Matrix<double, D, D>;

/// a to the power n >= 0, for sizes known at compile time.
constexpr int power(int a, int n) { return n == 0 ? 1 : a * power(a, n - 1); }

template <int D> Mat<D> identity() { return Mat<D>::Identity(); }

/// Symmetric part of a square matrix.
template <int D> Mat<D> sym(const Mat<D>& A) { return 0.5 * (A + A.transpose()); }

/// Double contraction A:B.
template <int D> double contract(const Mat<D>& A, const Mat<D>& B) { return A.cwiseProduct(B).sum(); }

/// Cofactor matrix, det(A) A^-T, defined for singular A too.
inline Mat<1> cofactor(const Mat<1>&) { return Mat<1>::Ones(); }
inline Mat<2> cofactor(const Mat<2>& A) {
    Mat<2> C;
    C << A(1, 1), -A(1, 0), -A(0, 1), A(0, 0);
    return C;
}

}  // namespace mpm
