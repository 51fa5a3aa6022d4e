/// Watches a run against a manufactured motion: the errors of review A.2.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "chapters/mms/norms.hpp"
#include "lab/norms.hpp"

namespace mpm {

/// The scene's Observer. The scene tells u(X, t), the exact displacement. `TotalLagrangian` schemes weigh the errors with V0, the others
/// with V (end of A.2).
template <class Scene, bool TotalLagrangian> struct DisplacementObserver {
    const Scene& scene;
    DisplacementError norms{};

    template <class Points> void sample(const Points& points, double t, double) {
        norms.sample(
            points, [&](const auto& p) { return scene.u(p.X, t); }, [](const auto& p) { return TotalLagrangian ? p.V0 : p.V; });
    }
    bool wants_energy(double, double) const { return false; }
    std::vector<NamedError> errors(double) const { return {{"e1", norms.e1()}, {"e2", norms.e2()}, {"rmse", norms.rmse()}}; }
    std::vector<std::pair<std::string, double>> facts(double) const {
        return {{"largest rms error in time, e1", norms.e1()},
                {"relative error over time, e2", norms.e2()},
                {"rms over time (6.7)", norms.rmse()}};
    }
};

}  // namespace mpm
