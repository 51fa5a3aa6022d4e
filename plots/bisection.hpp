/// The largest stable time step, by bisection.
#pragma once
#include <cmath>
#include <functional>
#include <optional>
#include <string>

namespace mpm {

/// What came of one run with a time step.
struct Trial {
    double fraction = 0;          // the step that it took, of h/(c + |v|)
    double error = 0;             // where it ended well
    std::string verdict, reason;  // "ok", "unstable:energy-growth", "failed:signal 11"
    bool stable() const { return verdict == "ok"; }
};

/// The largest fraction found stable and the smallest found not to be, each with its run.
struct Limit {
    std::optional<Trial> stable, unstable;
    int runs = 0;
};

/// Brackets the limit from `start` by doubling or halving, then halves the bracket in its logarithm until it is narrower than `tolerance`.
/// Outside low ... high it does not look. `attempt` returns nothing when interrupted, and then so does this. A scheme that is stable again
/// beyond an unstable step is not found out: what is found is one place where it begins to fail.
inline std::optional<Limit> largest_stable(double start, double low, double high, double tolerance,
                                           const std::function<std::optional<Trial>(double fraction)>& attempt) {
    Limit limit;
    double below = 0, above = 0;  // known stable, known unstable; 0: not known
    for (double fraction = start;;) {
        const auto trial = attempt(fraction);
        if (!trial) return {};
        ++limit.runs;
        if (trial->stable())
            below = fraction, limit.stable = trial;
        else
            above = fraction, limit.unstable = trial;
        if (below > 0 && above > 0) {
            if (above / below <= 1 + tolerance) return limit;
            fraction = std::sqrt(below * above);
        } else {
            fraction = trial->stable() ? 2 * fraction : fraction / 2;
            if (fraction > high || fraction < low) return limit;
        }
    }
}

}  // namespace mpm
