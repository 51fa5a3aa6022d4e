/// Error norms of a manufactured solution (review A.2 and equation 6.7), gathered at every step from the start to the end of a run.
#pragma once
#include <cmath>

#include "lab/math.hpp"

namespace mpm {

/// e1 (A.12), the largest over time of the root mean square error in space (A.11), in units of length; e2 (A.13), relative and over all
/// steps; and the root mean square over particles and steps (6.7).
///
/// Why (6.7) flatters: it is a mean over time, so an error e that has grown to full size only in the last part f of a run enters as
/// sqrt(f) e, and what e1 calls a failure still looks like convergence. It does not shrink by itself as the review says, since its sum
/// has n_T n_p terms: a constant error e gives e however fine the grid. (With the division outside the root it would, as 1/sqrt(n_T
/// n_p).)
class DisplacementError {
public:
    /// One moment: exact(p) is the displacement that particle p should have, volume(p) its weight in (A.11) and (A.13).
    template <class Points, class Exact, class Volume> void sample(const Points& points, Exact&& exact, Volume&& volume) {
        double V_error2 = 0, V_exact2 = 0, V_total = 0;
        for (const auto& p : points) {
            const auto u = exact(p);
            const double V = volume(p), error2 = (p.x - p.X - u).squaredNorm();
            V_total += V;
            V_error2 += V * error2;
            V_exact2 += V * u.squaredNorm();
            error2_ += error2;
        }
        const double e = std::sqrt(V_error2 / V_total);
        if (e > largest_ || std::isnan(e)) largest_ = e;
        V_error2_ += V_error2;
        V_exact2_ += V_exact2;
        count_ += static_cast<double>(points.size());
    }
    double e1() const { return largest_; }
    double e2() const { return std::sqrt(V_error2_ / V_exact2_); }
    double rmse() const { return std::sqrt(error2_ / count_); }

private:
    double largest_ = 0, V_error2_ = 0, V_exact2_ = 0, error2_ = 0, count_ = 0;
};

}  // namespace mpm
