/// Moving least squares (MLS, review appendix D): a polynomial is fitted about a place to values at scattered points, near ones counting
/// more; its value there is the approximation. It has no nodes of its own: the place is a grid node, a cell's centre, anything.
#pragma once
#include <cmath>
#include <string>

#include "chapters/improved/near_points.hpp"
#include "lab/math.hpp"

namespace mpm {

/// Spline weights of a distance r >= 0 in parts of the support: cubic (D.6) and quartic (D.7). Both end with a continuous slope.
inline double cubic_weight(double r) {
    if (r <= 0.5) return 2.0 / 3 + 4 * r * r * (r - 1);
    return r < 1 ? 4.0 / 3 * (1 - r) * (1 - r) * (1 - r) : 0;
}
inline double quartic_weight(double r) { return r < 1 ? (1 - r) * (1 - r) * (1 - r) * (1 + 3 * r) : 0; }

/// Terms of a polynomial of that degree in D variables: 1; r_1 ... r_D; their products.
constexpr int mls_terms(int dim, int degree) { return degree == 0 ? 1 : degree == 1 ? 1 + dim : 1 + dim + dim * (dim + 1) / 2; }

/// One fit of F values. Points are told by their distances from the place in parts of the support, so that every entry of the moment
/// matrix (D.3) is of order one in any units and on any grid, and the value at the place is the polynomial's first coefficient.
template <int D, int Degree, int F> class MlsFit {
public:
    static constexpr int terms = mls_terms(D, Degree);
    using Values = Eigen::Matrix<double, F, 1>;

    void add(const Vec<D>& r, double w, const Values& u) {
        const Eigen::Matrix<double, terms, 1> p = basis(r);
        for (int i = 0; i < terms; ++i) {
            for (int j = i; j < terms; ++j) A_(i, j) += w * p[i] * p[j];
            b_.row(i) += w * p[i] * u.transpose();
        }
    }

    /// What the points allow: the degree of the fit, -1 if there are no points, and its values at the place (zero then).
    struct Answer {
        int degree = -1;
        Values values = Values::Zero();
    };

    /// Elimination in the order of the basis, so that a lower degree is a leading part of the system. Two things end the fit at a lower
    /// degree: a term of which the points tell less than `least` of its mean square beyond the terms before it (too few points, points on a
    /// line), and a place so far beyond the points that it would amplify them: s_0 (A^-1)_00, 1 for a mean, above `limit`.
    Answer solve(double limit) {
        Answer answer;
        Eigen::Matrix<double, terms, 1> y = Eigen::Matrix<double, terms, 1>::Unit(0);  // becomes L^-1 e_0
        double amplified = 0;
        for (int k = 0; k < terms; ++k) {
            double rest = A_(k, k);
            for (int i = 0; i < k; ++i) rest -= A_(i, k) * A_(i, k) / A_(i, i);
            if (!(rest > least * A_(k, k))) break;
            for (int i = 0; i < k; ++i) {
                const double l = A_(i, k) / A_(i, i);
                for (int j = k + 1; j < terms; ++j) A_(k, j) -= l * A_(i, j);
                b_.row(k) -= l * b_.row(i);
                y[k] -= l * y[i];
            }
            A_(k, k) = rest;
            amplified += y[k] * y[k] / rest * A_(0, 0);
            if (amplified > limit) break;
            if (k + 1 == mls_terms(D, answer.degree + 1)) ++answer.degree;
        }
        if (answer.degree < 0) return answer;
        const int used = mls_terms(D, answer.degree);
        for (int k = terms - 1; k >= 0; --k) {
            if (k >= used) continue;
            for (int j = k + 1; j < terms; ++j)
                if (j < used) b_.row(k) -= A_(k, j) * b_.row(j);
            b_.row(k) /= A_(k, k);
        }
        answer.values = b_.row(0).transpose();
        return answer;
    }
    static constexpr double least = 1e-4;

private:
    static Eigen::Matrix<double, terms, 1> basis(const Vec<D>& r) {
        Eigen::Matrix<double, terms, 1> p;
        p[0] = 1;
        if constexpr (Degree > 0) p.template segment<D>(1) = r;
        if constexpr (Degree > 1)
            for (int i = 0, k = 1 + D; i < D; ++i)
                for (int j = i; j < D; ++j) p[k++] = r[i] * r[j];
        return p;
    }

    Eigen::Matrix<double, terms, terms> A_ = Eigen::Matrix<double, terms, terms>::Zero();  // the upper half
    Eigen::Matrix<double, terms, F> b_ = Eigen::Matrix<double, terms, F>::Zero();
};

/// What a fit is made with. The support is a circle about the place, `support` cells in radius (an ellipse where cells are no squares).
struct MlsChoice {
    int degree = 1;          // of the polynomial: 0 (Shepard, D.1), 1, 2
    double support = 1.1;    // d_I [cells]
    bool quartic = false;    // the weight (D.7), else (D.6)
    double limit = 1e4;      // of the square of a fit's amplification of noise; a higher one is of a lower degree

    double weight(double r) const { return quartic ? quartic_weight(r) : cubic_weight(r); }
};

/// The approximation at x of values(p), F of them, known at the points p around: `mls_at<1>(choice, near, points, x, [](const auto& p)
/// { return p.v; })`. Points are where `near` has found them.
template <int F, int D, class Points, class Values>
auto mls_at(const MlsChoice& choice, const NearPoints<D>& near, const Points& points, const Vec<D>& x, Values&& values) {
    const Vec<D> reach = choice.support * near.lattice().h(), per_reach = reach.cwiseInverse();
    const auto fitted = [&](auto fit) {
        near.visit(x, reach, [&](std::size_t i) {
            const Vec<D> r = (points[i].x - x).cwiseProduct(per_reach);
            const double r2 = r.squaredNorm();
            if (r2 < 1) fit.add(r, choice.weight(std::sqrt(r2)), values(points[i]));
        });
        const auto answer = fit.solve(choice.limit);
        return typename MlsFit<D, 0, F>::Answer{answer.degree, answer.values};
    };
    if (choice.degree == 0) return fitted(MlsFit<D, 0, F>{});
    if (choice.degree == 1) return fitted(MlsFit<D, 1, F>{});
    return fitted(MlsFit<D, 2, F>{});
}

/// Fits, and those that were of a lower degree than asked for, or had no points at all.
struct MlsCounts {
    long fits = 0, lower = 0, none = 0;
    void see(int degree, const MlsChoice& choice) {
        ++fits;
        if (degree < choice.degree) ++lower;
        if (degree < 0) ++none;
    }
};

}  // namespace mpm
