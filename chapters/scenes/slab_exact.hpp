/// Exact temperatures of a slab 0 <= xi <= 1 (Carslaw and Jaeger 1959, chapter 3), as series in the Fourier number Fo = kappa t/L^2. All
/// dimensionless; a rectangle's are their products.
#pragma once
#include <cmath>
#include <numbers>
#include <vector>

namespace mpm::slab {

/// Terms are left out once their exponential is below e^-40, and after `most`.
inline constexpr int most = 200000;

/// Sum of term(n) exp(-(n pi)^2 Fo) for n = 1, 2 ... .
template <class Term> double fourier_sum(double Fo, Term&& term) {
    const double rate = std::numbers::pi * std::numbers::pi * Fo;
    double sum = 0;
    for (int n = 1; n <= most && rate * n * n < 40; ++n) sum += term(n) * std::exp(-rate * n * n);
    return sum;
}

/// 0 at the start and at xi = 0, 1 at xi = 1 (review 5.27).
inline double between_held_ends(double xi, double Fo) {
    if (Fo <= 0) return xi < 1 ? 0 : 1;
    return xi +
           fourier_sum(Fo, [&](int n) { return 2 * (n % 2 == 0 ? 1 : -1) / (n * std::numbers::pi) * std::sin(n * std::numbers::pi * xi); });
}

/// 1 at the start, 0 at both ends: a factor of (5.28).
inline double held_ends(double xi, double Fo) {
    if (Fo <= 0) return xi > 0 && xi < 1 ? 1 : 0;
    return fourier_sum(Fo, [&](int n) { return n % 2 == 0 ? 0 : 4 / (n * std::numbers::pi) * std::sin(n * std::numbers::pi * xi); });
}

/// 0 at the start, no flux at xi = 0, slope 1 at xi = 1.
inline double heated_end(double xi, double Fo) {
    if (Fo <= 0) return 0;
    constexpr double pi2 = std::numbers::pi * std::numbers::pi;
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
        double sum = 0;
        for (std::size_t n = 0; n < 20000; ++n) {
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
