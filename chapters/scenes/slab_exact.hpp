/// Exact temperatures of a slab 0 <= xi <= 1 (Carslaw and Jaeger 1959, chapters 2 and 3) by the Fourier number Fo = kappa t/L^2: a series,
/// and early, before one end feels the other, that of a half space from each end. All dimensionless; a rectangle's are their products.
#pragma once
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace mpm::slab {

/// What comes from the other end is less than erfc(1/sqrt(4 Fo)) = 1e-23; later, a series needs 30 terms at most.
inline bool early(double Fo) { return Fo < 0.005; }

/// What a half space of one held end, of one heated evenly, feels at the distance s from its end, as functions of s/sqrt(4 Fo): erfc and
/// its first two integrals.
inline double ierfc(double z) { return std::exp(-z * z) * std::numbers::inv_sqrtpi - z * std::erfc(z); }
inline double i2erfc(double z) { return (std::erfc(z) - 2 * z * ierfc(z)) / 4; }
/// exp(z^2) erfc(z), z >= 0: from 25 on by its asymptotic series, whose next term is 1e-10.
inline double erfcx(double z) {
    if (z < 25) return std::exp(z * z) * std::erfc(z);
    const double q = 1 / (2 * z * z);
    return std::numbers::inv_sqrtpi / z * (1 - q * (1 - 3 * q * (1 - 5 * q)));
}

/// Sum of term(n) exp(-(n pi)^2 Fo) for n = 1, 2 ... until the exponential is below e^-40.
template <class Term> double fourier_sum(double Fo, Term&& term) {
    const double rate = std::numbers::pi * std::numbers::pi * Fo;
    double sum = 0;
    for (int n = 1; rate * n * n < 40; ++n) sum += term(n) * std::exp(-rate * n * n);
    return sum;
}

/// 0 at the start and at xi = 0, 1 at xi = 1 (review 5.27).
inline double between_held_ends(double xi, double Fo) {
    using std::numbers::pi;
    if (Fo <= 0) return xi < 1 ? 0 : 1;
    if (early(Fo)) return std::erfc((1 - xi) / std::sqrt(4 * Fo));
    return xi + fourier_sum(Fo, [&](int n) { return 2 * (n % 2 == 0 ? 1 : -1) / (n * pi) * std::sin(n * pi * xi); });
}
/// Its mean over xi.
inline double between_held_ends_mean(double Fo) {
    constexpr double pi2 = std::numbers::pi * std::numbers::pi;
    if (Fo <= 0) return 0;
    if (early(Fo)) return std::sqrt(4 * Fo) * std::numbers::inv_sqrtpi;
    return 0.5 - fourier_sum(Fo, [&](int n) { return n % 2 == 0 ? 0 : 4 / (pi2 * n * n); });
}

/// 1 at the start, 0 at both ends: a factor of (5.28).
inline double held_ends(double xi, double Fo) {
    using std::numbers::pi;
    if (Fo <= 0) return xi > 0 && xi < 1 ? 1 : 0;
    if (early(Fo)) return 1 - std::erfc(xi / std::sqrt(4 * Fo)) - std::erfc((1 - xi) / std::sqrt(4 * Fo));
    return fourier_sum(Fo, [&](int n) { return n % 2 == 0 ? 0 : 4 / (n * pi) * std::sin(n * pi * xi); });
}

/// 0 at the start and at both ends, heated evenly: the curvature of the steady state is -1. So is the velocity between plates (Poiseuille).
inline double heated_evenly(double xi, double Fo) {
    using std::numbers::pi;
    if (Fo <= 0) return 0;
    if (early(Fo)) return Fo * (1 - 4 * i2erfc(xi / std::sqrt(4 * Fo)) - 4 * i2erfc((1 - xi) / std::sqrt(4 * Fo)));
    return xi * (1 - xi) / 2 - fourier_sum(Fo, [&](int n) { return n % 2 == 0 ? 0 : 4 / std::pow(n * pi, 3) * std::sin(n * pi * xi); });
}
/// Its mean over xi.
inline double heated_evenly_mean(double Fo) {
    if (Fo <= 0) return 0;
    if (early(Fo)) return Fo * (1 - 8 * std::sqrt(Fo) * std::numbers::inv_sqrtpi / 3);
    return 1.0 / 12 - fourier_sum(Fo, [&](int n) { return n % 2 == 0 ? 0 : 8 / std::pow(n * std::numbers::pi, 4); });
}

/// 0 at the start, no flux at xi = 0, slope 1 at xi = 1.
inline double heated_end(double xi, double Fo) {
    constexpr double pi2 = std::numbers::pi * std::numbers::pi;
    if (Fo <= 0) return 0;
    if (early(Fo)) return std::sqrt(4 * Fo) * ierfc((1 - xi) / std::sqrt(4 * Fo));
    return Fo + (3 * xi * xi - 1) / 6 -
           2 / pi2 * fourier_sum(Fo, [&](int n) {
               return (n % 2 == 0 ? 1.0 : -1.0) / (static_cast<double>(n) * n) * std::cos(n * std::numbers::pi * xi);
           });
}

/// cos(pi xi) at the start, no flux at either end.
inline double insulated(double xi, double Fo) {
    return std::cos(std::numbers::pi * xi) * std::exp(-std::numbers::pi * std::numbers::pi * Fo);
}

/// 1 at the start, no flux at xi = 0, slope -Bi times the value at xi = 1 (convection; Bi = film coefficient L/k).
class ConvectiveEnd {
public:
    explicit ConvectiveEnd(double Bi) : Bi_(Bi) {}

    double operator()(double xi, double Fo) const {
        if (Fo <= 0) return 1;
        if (early(Fo)) {
            const double z = (1 - xi) / std::sqrt(4 * Fo);
            return 1 - std::erfc(z) + std::exp(-z * z) * erfcx(z + Bi_ * std::sqrt(Fo));
        }
        double sum = 0;
        for (std::size_t n = 0;; ++n) {
            const double mu = root(n);
            if (mu * mu * Fo > 40) break;
            sum += 2 * std::sin(mu) / (mu + std::sin(mu) * std::cos(mu)) * std::exp(-mu * mu * Fo) * std::cos(mu * xi);
        }
        return sum;
    }

private:
    /// The root of mu tan mu = Bi in (n pi, n pi + pi/2), by bisection of mu sin mu - Bi cos mu.
    double root(std::size_t n) const {
        while (roots_.size() <= n) {
            const double from = static_cast<double>(roots_.size()) * std::numbers::pi, sign = roots_.size() % 2 == 0 ? 1 : -1;
            double low = from, high = from + std::numbers::pi / 2;
            for (int i = 0; i < 60; ++i) {
                const double mu = (low + high) / 2;
                (sign * (mu * std::sin(mu) - Bi_ * std::cos(mu)) < 0 ? low : high) = mu;
            }
            roots_.push_back((low + high) / 2);
        }
        return roots_[n];
    }

    double Bi_;
    mutable std::vector<double> roots_{};  // found so far
};

}  // namespace mpm::slab
