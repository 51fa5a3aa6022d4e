/// Elasto-plastic solid of von Mises (J2) in rate form with radial return (review 6.1.3, B.3; Simo and Hughes 1998, chapter 3): perfectly
/// plastic, or hardening linearly. In 2D plane strain, in 1D uniaxial strain.
#pragma once
#include <array>
#include <cmath>
#include <limits>

#include "lab/math.hpp"

namespace mpm {

/// How stress follows a turning body.
///
/// The plain rate (B.5) leaves it behind: a turn by 90 degrees exchanges the axes and not the stress. What is more, L = (R - I)/dt of a
/// rigid turn by theta has the strain rate (cos(theta) - 1)/dt: many small turns look like compression. Both go if the step's deformation
/// is split into R U: the stress is strained by U on the axes at the start, and then turned (the un-rotated stress of B.3, step by step).
/// That is objective for steps of any size, and R in the plane costs one root.
enum class StressRate {
    plain,            // as printed
    corotated,        // L = grad v on positions at t: updated-Lagrangian schemes, R U = I + dt L
    corotated_total,  // L = grad v on positions at t + dt: TLMPM, U^-1 R^T = I - dt L
};

/// Trial stress += lambda tr(D dt) I + 2 mu D dt, its deviator scaled back to |s| = sqrt(2/3) (yield + H eps_p) where it is longer.
template <StressRate rate> struct VonMisesWith {
    static constexpr const char* name = "von-mises";
    static constexpr std::array<const char*, 1> columns{"eps_p"};  // of snapshots
    template <class Base> struct PointOf : Base {
        double sigma33 = 0;       // stress across the plane; in 1D that across the bar, sigma22 = sigma33
        double eps_p = 0;         // equivalent plastic strain [-]
        double plastic_work = 0;  // dissipated energy of the particle
    };

    double lambda = 0, mu = 0, rho = 1;                        // Lame constants [stress], initial density [mass/volume]
    double yield = std::numeric_limits<double>::infinity();   // stress in uniaxial tension at which it yields; infinite: elastic
    double H = 0;                                              // d(yield stress)/d(eps_p) [stress]

    double wave_speed() const { return std::sqrt((lambda + 2 * mu) / rho); }  // elastic P-wave (2.71)

    template <class Point, class Gradient> void update(Point& p, const Gradient& L, double dt) const {
        constexpr int D = Point::D;
        if constexpr (rate == StressRate::plain) return strain(p, Mat<D>(dt * sym<D>(L)));
        constexpr double sign = rate == StressRate::corotated ? 1 : -1;
        Mat<D> A = identity<D>() + sign * dt * L;
        if constexpr (rate == StressRate::corotated_total) A.transposeInPlace();
        const Mat<D> R = rotation(A), U = R.transpose() * A;  // or U^-1, whose logarithm is -ln U
        strain(p, sym<D>(sign * 2 * (U - identity<D>()) * (U + identity<D>()).inverse()));  // ln U, but for (U - I)^3/12
        p.sigma = Mat<D>(R * p.sigma * R.transpose());
    }

    /// Elastic energy of a particle, V [K (theta - 1 + exp(-theta)) + s:s/(4 mu)] with theta = mean stress/K: the work of the mean stress
    /// K ln J on the volume V, which at an impact is far from V0. For small theta V/2 sigma:eps (6.5).
    template <class Point> double energy(const Point& p) const {
        const double K = lambda + 2 * mu / 3, theta = mean(p) / K, s = deviator(p);
        return p.V * (K * (theta + std::expm1(-theta)) + s * s / (4 * mu));
    }
    /// All plastic work of a particle, that which hardens the material included.
    template <class Point> double dissipated(const Point& p) const { return p.plastic_work; }

    /// The von Mises stress sqrt(3/2) |s|.
    template <class Point> double mises(const Point& p) const { return std::sqrt(1.5) * deviator(p); }
    template <class Point> std::array<double, 1> values(const Point& p) const { return {p.eps_p}; }
    template <class Point> double sigma_zz(const Point& p) const { return p.sigma33; }

private:
    /// R of A = R U.
    static Mat<1> rotation(const Mat<1>&) { return identity<1>(); }
    static Mat<2> rotation(const Mat<2>& A) {
        const double c = A(0, 0) + A(1, 1), s = A(1, 0) - A(0, 1), r = std::sqrt(c * c + s * s);
        Mat<2> R;
        R << c / r, -s / r, s / r, c / r;
        return R;
    }

    template <class Point, class Strain> void strain(Point& p, const Strain& de) const {
        p.sigma += lambda * de.trace() * identity<Point::D>() + 2 * mu * de;
        p.sigma33 += lambda * de.trace();
        return_to_yield(p);
    }

    template <class Point> static double mean(const Point& p) { return (p.sigma.trace() + (3 - Point::D) * p.sigma33) / 3; }
    /// |s| of all three axes.
    template <class Point> static double deviator(const Point& p) {
        const double m = mean(p), s33 = p.sigma33 - m;
        return std::sqrt((p.sigma - m * identity<Point::D>()).squaredNorm() + (3 - Point::D) * s33 * s33);
    }

    template <class Point> void return_to_yield(Point& p) const {
        constexpr int D = Point::D;
        const double trial = deviator(p), excess = trial - std::sqrt(2.0 / 3) * (yield + H * p.eps_p);
        if (!(excess > 0)) return;
        const double deps_p = std::sqrt(2.0 / 3) * excess / (2 * mu + 2 * H / 3);
        p.eps_p += deps_p;
        const double flow = yield + H * p.eps_p, scale = std::sqrt(2.0 / 3) * flow / trial, m = mean(p);
        p.sigma = Mat<D>(m * identity<D>() + scale * (p.sigma - m * identity<D>()));
        p.sigma33 = m + scale * (p.sigma33 - m);
        p.plastic_work += p.V * flow * deps_p;
    }
};

using VonMises = VonMisesWith<StressRate::corotated>;

}  // namespace mpm
