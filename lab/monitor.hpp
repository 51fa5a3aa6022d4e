/// What the run loop watches: energies, momentum, and the signs that a run has become unstable.
#pragma once
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "lab/body.hpp"

namespace mpm {

/// Sums over all bodies at one moment.
struct Measures {
    double kinetic = 0, strain = 0;  // energies
    double momentum = 0;             // magnitude of the total momentum; in 1D with its sign
    double total() const { return kinetic + strain; }
};

template <class Bodies> Measures measure(const Bodies& bodies) {
    constexpr int D = Bodies::value_type::D;
    Measures sum;
    Vec<D> mv = Vec<D>::Zero();
    for (const auto& body : bodies)
        for (const auto& p : body.points) {
            sum.kinetic += 0.5 * p.m * p.v.squaredNorm();
            sum.strain += body.law.energy(p);
            mv += p.m * p.v;
        }
    sum.momentum = D == 1 ? mv[0] : mv.norm();
    return sum;
}

/// A named instability and the number that shows it.
struct Trouble {
    std::string cause;   // "" when all is well, else e.g. "energy-growth"
    std::string reason;  // one sentence
    explicit operator bool() const { return !cause.empty(); }
};

/// The first particle that is turned inside out, or whose velocity is not a number. Positions are checked where weights are made.
template <class Bodies> Trouble check_particles(const Bodies& bodies) {
    for (const auto& body : bodies)
        for (std::size_t i = 0; i < body.points.size(); ++i) {
            const auto& p = body.points[i];
            if (p.V > 0 && p.V < 1e300) [[likely]]
                continue;
            std::ostringstream s;
            s << "particle " << i << " at x = " << p.x.transpose() << " has V/V0 = det F = " << p.V / p.V0;
            return {std::isfinite(p.V) ? "inverted-particle" : "not-finite", s.str()};
        }
    return {};
}

/// Energy that the balance cannot account for: growth by more than 5 % of the energy in play.
class EnergyWatch {
public:
    Trouble check(double energy, double work = 0) {
        const double balance = energy - work;
        if (first_) first_ = false, start_ = balance;
        in_play_ = std::max(in_play_, energy);
        growth_ = (balance - start_) / in_play_;
        if (!(growth_ <= limit)) {
            std::ostringstream s;
            s << "energy grew from " << start_ << " to " << balance << ", more than 5 % of the energy in play";
            return {"energy-growth", s.str()};
        }
        return {};
    }
    double growth() const { return growth_; }
    static constexpr double limit = 0.05;

private:
    bool first_ = true;
    double start_ = 0, in_play_ = 0, growth_ = 0;
};

}  // namespace mpm
