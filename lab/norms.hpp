/// Measures of error: frequency, amplitude and L2 of a signal against its exact value; observed orders.
#pragma once
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace mpm {

struct NamedError {
    std::string name;
    double value;
};

/// Order between two resolutions: log(e1/e2)/log(h1/h2).
inline double observed_order(double e1, double h1, double e2, double h2) { return std::log(e1 / e2) / std::log(h1 / h2); }

/// A signal that oscillates about zero, sampled at every step, beside its exact value.
class Oscillation {
public:
    void sample(double t, double value, double exact, double energy) {
        diff2_ += (value - exact) * (value - exact);
        exact2_ += exact * exact;
        if (count_++ > 0 && last_ * value < 0) {  // a zero between two samples, by linear interpolation
            const double zero = last_t_ + (t - last_t_) * last_ / (last_ - value);
            if (zeros_++ == 0) first_zero_ = zero;
            last_zero_ = zero;
        }
        last_ = value;
        last_t_ = t;
        if (!std::isnan(energy)) energies_.emplace_back(t, energy);
    }
    /// Angular frequency from the zero crossings; nan with fewer than two.
    double omega() const {
        return zeros_ > 1 ? std::numbers::pi * (zeros_ - 1) / (last_zero_ - first_zero_) : std::numeric_limits<double>::quiet_NaN();
    }
    double relative_l2() const { return std::sqrt(diff2_ / exact2_); }
    /// Mean energy over the last period divided by that over the first.
    double energy_kept(double period, double t_end) const {
        double first = 0, last = 0;
        int n_first = 0, n_last = 0;
        for (const auto& [t, e] : energies_) {
            if (t <= period) first += e, ++n_first;
            if (t >= t_end - period) last += e, ++n_last;
        }
        return last / n_last / (first / n_first);
    }

private:
    double diff2_ = 0, exact2_ = 0, last_ = 0, last_t_ = 0, first_zero_ = 0, last_zero_ = 0;
    int zeros_ = 0;
    long count_ = 0;
    std::vector<std::pair<double, double>> energies_;
};

}  // namespace mpm
