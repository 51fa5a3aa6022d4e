/// What `stability` tries on each variant: steps up to the largest stable one, and the stiff cases.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plots/bisection.hpp"
#include "plots/sweep.hpp"

namespace mpm {

struct Limits {
    int cells = 32, finest = 4096;
    double periods = 20, case_periods = 2, tolerance = 0.01, timeout = 0;
    std::string error;  // error_name; "" for the first
};

/// A stiff case: what a program is told beside its own options.
struct Case {
    std::string name, value;   // "contrast", "1e6"
    std::string title;         // for the screen
    std::string above, below;  // two lines over its column in the map
    int cells;
    double periods;
    Words needs, words;  // options that a program must have; what it is told
};
/// `ppc` places a particle beside a node.
std::vector<Case> stiff_cases(const Words& contrasts, const Limits& limits, int ppc);

/// What a case came to for one variant.
struct Found {
    std::string error_name = "none", verdict = "left out", reason;
    double error, dt, fraction, t_fail;
    std::string shown() const;  // "1.9e-4", "energy-growth"
};

/// What a program's critical step is, the unit of its --cfl: "h/(c + |v|)", "h^2/(2 kappa)".
std::string critical_name(Programs& programs, const std::string& program);

/// The largest stable step by bisection, as a fraction of the critical one, which the first run tells; `run` gets further words for the
/// program. Nothing when interrupted.
std::optional<Limit> largest_step(double tolerance, double& critical_dt,
                                  const std::function<std::optional<Found>(const Words& more)>& run);

/// Runs one variant as a process.
class Prober {
public:
    Prober(Programs& programs, const Variant& variant, const Limits& limits, const std::string& folder);

    /// The largest stable step; nothing when interrupted.
    std::optional<Limit> largest_step();
    std::optional<Found> run(const Case& stiff);
    int particles_per_cell() const;
    double critical_dt() const { return critical_dt_; }

private:
    std::optional<Found> run(const std::string& name, int cells, double periods, const Words& more);
    Programs& programs_;
    const Variant& variant_;
    const Limits& limits_;
    std::string folder_;
    double critical_dt_ = 0;
};

}  // namespace mpm
