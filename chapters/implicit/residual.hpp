/// The residual of implicit MPM (Aulisa and Capodaglio, equations 20 to 25) for one particle in its element, with the neo-Hookean stress (12),
/// and its tangent in two ways: by automatic differentiation and by hand.
///
///   r_I = m [(a - b) phi_I + tau grad_x phi_I/rho0],  tau = J sigma = lambda ln J 1 + mu (F F^T - 1),  F = f F^n,  f = 1 + theta sum u_K grad
///   phi_K,  grad_x phi = f^-T grad phi.
///
/// Test functions have their gradients on the deformed grid; the second term of the printed (23) lacks 1/rho.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

#include "chapters/explicit/point.hpp"
#include "chapters/implicit/element.hpp"
#include "chapters/implicit/newmark.hpp"
#include "chapters/material/neo_hookean.hpp"

namespace mpm {

template <int Dim> struct ImplicitPoint : Point<Dim> {
    Vec<Dim> a = Vec<Dim>::Zero();  // acceleration
};

/// A step's settings, as the residual needs them.
template <int D> struct StepOf {
    Newmark newmark;
    double dt;
    Vec<D> b;  // body force per mass
};

namespace detail {
template <class T> T determinant(const Eigen::Matrix<T, 1, 1>& A) { return A(0, 0); }
template <class T> T determinant(const Eigen::Matrix<T, 2, 2>& A) { return T(A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0)); }
/// det(A) A^-T
template <class T> Eigen::Matrix<T, 1, 1> cofactor_of(const Eigen::Matrix<T, 1, 1>&) { return Eigen::Matrix<T, 1, 1>::Constant(T(1)); }
template <class T> Eigen::Matrix<T, 2, 2> cofactor_of(const Eigen::Matrix<T, 2, 2>& A) {
    Eigen::Matrix<T, 2, 2> C;
    C << A(1, 1), T(-A(1, 0)), T(-A(0, 1)), A(0, 0);
    return C;
}
}  // namespace detail

/// An element's unknowns or residual: component d of node k at k D + d.
template <class T, int D, int N> using ElementVector = Eigen::Matrix<T, N * D, 1>;

/// Adds the particle's part of the residual to r. T is double, or a number that carries its derivatives. False if f is turned inside out.
template <class T, int D, int N, class Point>
bool add_residual(const Point& p, const NeoHookean& law, const ElementWeights<D, N>& w, const ElementVector<T, D, N>& u, const StepOf<D>& step,
                  ElementVector<T, D, N>& r) {
    using std::log;
    Eigen::Matrix<T, D, 1> inertia;                                       // m (a - b)
    Eigen::Matrix<T, D, D> f;
    for (int i = 0; i < D; ++i) {
        T u_i(0.0);
        for (int k = 0; k < N; ++k) u_i += u[k * D + i] * w.phi[static_cast<std::size_t>(k)];               // 22
        inertia[i] = p.m * (step.newmark.inertia(step.dt) * u_i - (step.newmark.known(p, step.dt)[i] + step.b[i]));  // 21
        for (int j = 0; j < D; ++j) {
            f(i, j) = T(i == j ? 1.0 : 0.0);
            for (int k = 0; k < N; ++k) f(i, j) += u[k * D + i] * (step.newmark.theta * w.trial[static_cast<std::size_t>(k)][j]);  // 25
        }
    }
    const T det_f = detail::determinant(f);
    if (!(det_f > 0)) return false;
    Eigen::Matrix<T, D, D> F, tau, stress;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
            F(i, j) = T(0.0);
            for (int k = 0; k < D; ++k) F(i, j) += f(i, k) * p.F(k, j);                                       // 24
        }
    const T pressure = law.lambda * log(det_f * p.F.determinant());
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
            T B(0.0);
            for (int k = 0; k < D; ++k) B += F(i, k) * F(j, k);
            tau(i, j) = i == j ? T(pressure + law.mu * (B - 1.0)) : T(law.mu * B);                            // 12, times J
        }
    const Eigen::Matrix<T, D, D> C = detail::cofactor_of(f);
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
            T sum(0.0);
            for (int k = 0; k < D; ++k) sum += tau(i, k) * C(k, j);
            stress(i, j) = p.V0 * sum / det_f;                                                                // m/rho0 tau f^-T
        }
    for (int k = 0; k < N; ++k)
        for (int i = 0; i < D; ++i) {
            r[k * D + i] += inertia[i] * w.phi[static_cast<std::size_t>(k)];                                  // 20
            for (int j = 0; j < D; ++j) r[k * D + i] += stress(i, j) * w.grad[static_cast<std::size_t>(k)][j];
        }
    return true;
}

/// An element's tangent dr/du, row by row.
template <int D, int N> using ElementMatrix = Eigen::Matrix<double, N * D, N * D, Eigen::RowMajor>;

/// Adds the particle's part by automatic differentiation of add_residual, each number with its N D derivatives.
template <int D, int N, class Point>
void add_ad_tangent(const Point& p, const NeoHookean& law, const ElementWeights<D, N>& w, const ElementVector<double, D, N>& u,
                    const StepOf<D>& step, ElementMatrix<D, N>& K) {
    using Number = Eigen::AutoDiffScalar<Eigen::Matrix<double, N * D, 1>>;
    ElementVector<Number, D, N> unknown, r;
    for (int i = 0; i < N * D; ++i) {
        unknown[i] = Number(u[i], N * D, i);
        r[i] = Number(0.0);
    }
    add_residual<Number, D, N>(p, law, w, unknown, step, r);
    for (int i = 0; i < N * D; ++i) K.row(i) += r[i].derivatives().transpose();
}

/// The same by hand. With l = du f^-1 = sum du_K g*_K^T, g = f^-T grad: d(tau g_I) = lambda (tr l) g_I + mu (l B + B l^T) g_I - tau l^T g_I,
/// where B in the last two terms cancels. Symmetric where trial gradients are those of the test functions.
template <int D, int N, class Point>
void add_tangent(const Point& p, const NeoHookean& law, const ElementWeights<D, N>& w, const ElementVector<double, D, N>& u,
                 const StepOf<D>& step, ElementMatrix<D, N>& K) {
    Mat<D> f = identity<D>();
    for (int k = 0; k < N; ++k)
        f += step.newmark.theta * u.template segment<D>(k * D) * w.trial[static_cast<std::size_t>(k)].transpose();
    const Mat<D> F = f * p.F, B = F * F.transpose(), f_invT = cofactor(f) / f.determinant();
    const double V = step.newmark.theta * p.V0, lnJ = std::log(F.determinant()), inertia = p.m * step.newmark.inertia(step.dt);
    Eigen::Matrix<double, D, N> test, trial;
    for (int k = 0; k < N; ++k) {
        test.col(k) = f_invT * w.grad[static_cast<std::size_t>(k)];
        trial.col(k) = f_invT * w.trial[static_cast<std::size_t>(k)];
    }
    const Eigen::Matrix<double, D, N> B_trial = V * law.mu * B * trial, volume = V * law.lambda * trial, shear = V * (law.mu - law.lambda * lnJ) * trial;
    for (int i = 0; i < N; ++i)
        for (int k = 0; k < N; ++k) {
            const double same = B_trial.col(k).dot(test.col(i)) + inertia * w.phi[static_cast<std::size_t>(i)] * w.phi[static_cast<std::size_t>(k)];
            for (int c = 0; c < D; ++c) {
                for (int d = 0; d < D; ++d) K(i * D + c, k * D + d) += test(c, i) * volume(d, k) + shear(c, k) * test(d, i);
                K(i * D + c, k * D + c) += same;
            }
        }
}

}  // namespace mpm
