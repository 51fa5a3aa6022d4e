/// What the run loop watches: energies, momentum, what flows in and out, and the signs that a run has become unstable.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "lab/body.hpp"

namespace mpm {

/// Sums over all bodies at one moment.
struct Measures {
    double kinetic = 0, strain = 0, dissipated = 0;  // energies
    std::array<double, 2> momentum{};                // components; the second is 0 in 1D
    double momentum_in_play = 0;                     // sum of m |v|
    double total() const { return kinetic + strain; }
    double balance() const { return kinetic + strain + dissipated; }
};

template <class Bodies> Measures measure(const Bodies& bodies) {
    constexpr int D = Bodies::value_type::D;
    Measures sum;
    Vec<D> mv = Vec<D>::Zero();
    for (const auto& body : bodies)
        for (const auto& p : body.points) {
            const double v2 = p.v.squaredNorm();
            sum.kinetic += 0.5 * p.m * v2;
            sum.strain += body.law.energy(p);
            if constexpr (requires { body.law.dissipated(p); }) sum.dissipated += body.law.dissipated(p);
            sum.momentum_in_play += p.m * std::sqrt(v2);
            mv += p.m * p.v;
        }
    for (int d = 0; d < D; ++d) sum.momentum[static_cast<std::size_t>(d)] = mv[d];
    return sum;
}

/// What a step brings in from outside: impulse of loads and held nodes, work of loads.
struct Supply {
    std::array<double, 2> impulse{};
    double work = 0;
};

/// A named instability and the number that shows it.
struct Trouble {
    std::string cause;   // "" when all is well, else e.g. "energy-growth"
    std::string reason;  // one sentence
    explicit operator bool() const { return !cause.empty(); }
};

namespace detail {
template <class Point> std::string place(std::size_t body, std::size_t i, const Point& p) {
    std::ostringstream s;
    s << "particle " << i << (body > 0 ? " of body " + std::to_string(body) : std::string()) << " at x = " << p.x.transpose();
    return s.str();
}
}  // namespace detail

/// The first particle that is turned inside out or not a number. Positions are checked where weights are made.
template <class Bodies> Trouble check_particles(const Bodies& bodies) {
    for (std::size_t b = 0; b < bodies.size(); ++b)
        for (std::size_t i = 0; i < bodies[b].points.size(); ++i) {
            const auto& p = bodies[b].points[i];
            if (p.V > 0 && p.V < 1e300) [[likely]]
                continue;
            std::ostringstream s;
            s << detail::place(b, i, p) << " has V/V0 = det F = " << p.V / p.V0;
            return {std::isfinite(p.V) ? "inverted-particle" : "not-finite", s.str()};
        }
    return {};
}

/// Where a run is liveliest: the fastest particle, its speed, and its det F.
template <class Bodies> std::string fastest_particle(const Bodies& bodies) {
    std::string where;
    double most = -1;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        for (std::size_t i = 0; i < bodies[b].points.size(); ++i) {
            const auto& p = bodies[b].points[i];
            const double speed = p.v.norm();
            if (speed <= most) continue;
            most = speed;
            std::ostringstream s;
            s << detail::place(b, i, p) << " is the fastest, |v| = " << speed << ", det F = " << p.V / p.V0;
            where = s.str();
        }
    return where;
}

/// Energy that the balance kinetic + strain + dissipated - work cannot account for: growth by more than 5 % of the energy in play.
class EnergyWatch {
public:
    Trouble check(const Measures& now, double work) {
        const double balance = now.balance() - work;
        if (first_) first_ = false, start_ = balance;
        in_play_ = std::max({in_play_, now.total(), std::abs(work)});
        growth_ = in_play_ > 0 ? (balance - start_) / in_play_ : 0;
        if (growth_ <= limit) return {};
        std::ostringstream s;
        s << "energy less work grew from " << start_ << " to " << balance << ", by " << 100 * growth_ << " % of the energy in play";
        return {std::isfinite(balance) ? "energy-growth" : "not-finite", s.str()};
    }
    double growth() const { return growth_; }
    double in_play() const { return in_play_; }
    static constexpr double limit = 0.05;

private:
    bool first_ = true;
    double start_ = 0, in_play_ = 0, growth_ = 0;
};

}  // namespace mpm
