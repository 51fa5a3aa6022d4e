/// The residual of implicit MPM (Aulisa and Capodaglio, equations 20 to 25) for one particle in its element, with the neo-Hookean stress
/// (12), and its tangent in two ways: by automatic differentiation and by hand.
///
///   r_I = m [(a - b) phi_I + tau grad_x phi_I/rho0],  tau = J sigma = lambda ln J 1 + mu (F F^T - 1),
///   F = f F^n,  f = 1 + theta sum u_K grad phi_K,  grad_x phi = f^-T grad phi.
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
    Vec<D> b;                 // body force per mass
    bool conserving = false;  // the stress that keeps the energy
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
/// A B and A B^T, written out: Eigen does not multiply numbers of different kinds.
template <class T, class U, int D> Eigen::Matrix<T, D, D> product(const Eigen::Matrix<T, D, D>& A, const Eigen::Matrix<U, D, D>& B) {
    Eigen::Matrix<T, D, D> C;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
            C(i, j) = T(A(i, 0) * B(0, j));
            for (int k = 1; k < D; ++k) C(i, j) += A(i, k) * B(k, j);
        }
    return C;
}
template <class T, class U, int D>
Eigen::Matrix<T, D, D> product_transposed(const Eigen::Matrix<T, D, D>& A, const Eigen::Matrix<U, D, D>& B) {
    Eigen::Matrix<U, D, D> B_T;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) B_T(i, j) = B(j, i);
    return product(A, B_T);
}
}  // namespace detail

/// An element's unknowns or residual: component d of node k at k D + d.
template <class T, int D, int N> using ElementVector = Eigen::Matrix<T, N * D, 1>;

namespace detail {
/// tau f^-T of the stress (12) at F = f F^n.
template <class T, int D, class Point>
Eigen::Matrix<T, D, D> stress_at(const Point& p, const NeoHookean& law, const Eigen::Matrix<T, D, D>& f) {
    using std::log;
    const T det_f = determinant(f), pressure = law.lambda * log(det_f * p.F.determinant());
    const Eigen::Matrix<T, D, D> F = product(f, p.F), C = cofactor_of(f);
    Eigen::Matrix<T, D, D> tau = product_transposed(F, F), stress;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) tau(i, j) = i == j ? T(pressure + law.mu * (tau(i, j) - 1.0)) : T(law.mu * tau(i, j));
    stress = product(tau, C);
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) stress(i, j) /= det_f;
    return stress;
}

/// The same of the discrete gradient of Gonzalez (2000), whose work over the step is the change of the stored energy W: F_m S (F^n)^T with
/// F_m = (F^n + F)/2 and S = 2 dW/dC + 2 (dW - dW/dC : dC)/(dC : dC) dC at the mean of C = F^T F at both ends. Objective: it also keeps the
/// angular momentum.
template <class T, int D, class Point>
Eigen::Matrix<T, D, D> conserving_stress(const Point& p, const NeoHookean& law, const Eigen::Matrix<T, D, D>& f) {
    using std::log;
    constexpr double too_small = 1e-10;  // |dC|^2 of steps whose correction, of third order, is below rounding
    const Eigen::Matrix<T, D, D> F = product(f, p.F);
    const Mat<D> C0 = p.F.transpose() * p.F;
    Eigen::Matrix<T, D, D> C, dC, S, F_m;
    T dC2(0.0), trace(0.0);
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
            T sum(0.0);
            for (int k = 0; k < D; ++k) sum += F(k, i) * F(k, j);
            dC(i, j) = sum - C0(i, j);
            C(i, j) = 0.5 * (sum + C0(i, j));
            F_m(i, j) = 0.5 * (F(i, j) + p.F(i, j));
            dC2 += dC(i, j) * dC(i, j);
            if (i == j) trace += dC(i, j);
        }
    const T det_C = determinant(C), lnJ = 0.5 * log(det_C), ln_f = log(determinant(f));
    const double lnJ0 = std::log(p.F.determinant());
    const Eigen::Matrix<T, D, D> cofactor_C = cofactor_of(C);
    T work(0.0);
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
            const T inverse = cofactor_C(i, j) / det_C;
            S(i, j) = (i == j ? law.mu : 0.0) + (law.lambda * lnJ - law.mu) * inverse;
            work += 0.5 * S(i, j) * dC(i, j);
        }
    if (dC2 > too_small) {
        const T dW = 0.5 * law.mu * trace - law.mu * ln_f + 0.5 * law.lambda * ln_f * (ln_f + 2 * lnJ0);
        const T missing = 2.0 * (dW - work) / dC2;
        for (int i = 0; i < D; ++i)
            for (int j = 0; j < D; ++j) S(i, j) += missing * dC(i, j);
    }
    return product_transposed(product(F_m, S), p.F);
}
}  // namespace detail

/// Adds the particle's part of the residual to r. False if f is turned inside out.
template <class T, int D, int N, class Point>
bool add_residual(const Point& p, const NeoHookean& law, const ElementWeights<D, N>& w, const ElementVector<T, D, N>& u,
                  const StepOf<D>& step, ElementVector<T, D, N>& r) {
    Eigen::Matrix<T, D, 1> inertia;  // m (a - b)
    Eigen::Matrix<T, D, D> f;
    const double part = step.conserving ? 1 : step.newmark.theta;
    for (int i = 0; i < D; ++i) {
        T u_i(0.0);
        for (int k = 0; k < N; ++k) u_i += u[k * D + i] * w.phi[static_cast<std::size_t>(k)];                          // 22
        inertia[i] = p.m * (step.newmark.inertia(step.dt) * u_i - (step.newmark.known(p, step.dt)[i] + step.b[i]));    // 21
        for (int j = 0; j < D; ++j) {
            f(i, j) = T(i == j ? 1.0 : 0.0);
            for (int k = 0; k < N; ++k) f(i, j) += u[k * D + i] * (part * w.trial[static_cast<std::size_t>(k)][j]);  // 24, 25
        }
    }
    if (!(detail::determinant(f) > 0)) return false;
    Eigen::Matrix<T, D, D> stress;  // tau f^-T
    if (step.conserving) stress = detail::conserving_stress<T, D>(p, law, f);
    else stress = detail::stress_at<T, D>(p, law, f);
    for (int k = 0; k < N; ++k)
        for (int i = 0; i < D; ++i) {
            r[k * D + i] += inertia[i] * w.phi[static_cast<std::size_t>(k)];                                           // 20, m/rho0 = V0
            for (int j = 0; j < D; ++j) r[k * D + i] += stress(i, j) * (p.V0 * w.grad[static_cast<std::size_t>(k)][j]);
        }
    return true;
}

/// An element's tangent dr/du, row by row.
template <int D, int N> using ElementMatrix = Eigen::Matrix<double, N * D, N * D, Eigen::RowMajor>;

/// Adds the particle's part by automatic differentiation: the stress carries its D^2 derivatives by f, the rest is linear in u.
template <int D, int N, class Point>
void add_ad_tangent(const Point& p, const NeoHookean& law, const ElementWeights<D, N>& w, const ElementVector<double, D, N>& u,
                    const StepOf<D>& step, ElementMatrix<D, N>& K) {
    using Number = Eigen::AutoDiffScalar<Eigen::Matrix<double, D * D, 1>>;
    const double part = step.conserving ? 1 : step.newmark.theta, inertia = p.m * step.newmark.inertia(step.dt);
    Mat<D> at = identity<D>();
    for (int k = 0; k < N; ++k) at += part * u.template segment<D>(k * D) * w.trial[static_cast<std::size_t>(k)].transpose();
    Eigen::Matrix<Number, D, D> f, stress;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) f(i, j) = Number(at(i, j), D * D, i * D + j);
    if (step.conserving) stress = detail::conserving_stress<Number, D>(p, law, f);
    else stress = detail::stress_at<Number, D>(p, law, f);
    for (int k = 0; k < N; ++k)
        for (int d = 0; d < D; ++d) {
            Mat<D> by_u;  // of the stress, by component d of node k
            for (int i = 0; i < D; ++i)
                for (int j = 0; j < D; ++j)
                    by_u(i, j) = part * p.V0 * stress(i, j).derivatives().template segment<D>(d * D).dot(w.trial[std::size_t(k)]);
            for (int i = 0; i < N; ++i) {
                K.template block<D, 1>(i * D, k * D + d) += by_u * w.grad[static_cast<std::size_t>(i)];
                K(i * D + d, k * D + d) += inertia * w.phi[static_cast<std::size_t>(i)] * w.phi[static_cast<std::size_t>(k)];
            }
        }
}

/// The same by hand. With l = du f^-1 = sum du_K g*_K^T, g = f^-T grad: d(tau g_I) = lambda (tr l) g_I + mu (l B + B l^T) g_I - tau l^T
/// g_I, where B in the last two terms cancels. Symmetric where trial gradients are those of the test functions.
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
    const Eigen::Matrix<double, D, N> B_trial = V * law.mu * B * trial, volume = V * law.lambda * trial;
    const Eigen::Matrix<double, D, N> shear = V * (law.mu - law.lambda * lnJ) * trial;
    for (int i = 0; i < N; ++i)
        for (int k = 0; k < N; ++k) {
            const double phi2 = w.phi[static_cast<std::size_t>(i)] * w.phi[static_cast<std::size_t>(k)];
            const double same = B_trial.col(k).dot(test.col(i)) + inertia * phi2;
            for (int c = 0; c < D; ++c) {
                for (int d = 0; d < D; ++d) K(i * D + c, k * D + d) += test(c, i) * volume(d, k) + shear(c, k) * test(d, i);
                K(i * D + c, k * D + c) += same;
            }
        }
}

}  // namespace mpm
