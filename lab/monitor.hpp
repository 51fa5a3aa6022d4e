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

template <int D, class Point, class Node, class Law> void add_measures(const Matter<D, Point, Node, Law>& body, Measures& sum) {
    constexpr bool nodes_move = requires(const Node& node) { node.kinetic(); };  // finite elements: nodes hold the kinetic energy
    if constexpr (nodes_move)
        for (const Node& node : body.grid) sum.kinetic += node.kinetic();
    for (const Point& p : body.points) {
        const double v2 = p.v.squaredNorm();
        if constexpr (!nodes_move) sum.kinetic += 0.5 * p.m * v2;
        sum.strain += body.law.energy(p);
        if constexpr (requires { body.law.dissipated(p); }) sum.dissipated += body.law.dissipated(p);
        sum.momentum_in_play += p.m * std::sqrt(v2);
        for (int d = 0; d < D; ++d) sum.momentum[static_cast<std::size_t>(d)] += p.m * p.v[d];
    }
}
template <class Bodies> Measures measure(const Bodies& bodies) {
    Measures sum;
    for (const auto& body : bodies) add_measures(body, sum);
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
template <class Point> std::string place(std::size_t i, const Point& p) {
    std::ostringstream s;
    s << "particle " << i << " at x = " << p.x.transpose();
    return s.str();
}
}  // namespace detail

/// The first particle that is turned inside out or not a number. Positions are checked where weights are made.
template <int D, class Point, class Node, class Law> Trouble check_particles(const Matter<D, Point, Node, Law>& body) {
    for (std::size_t i = 0; i < body.points.size(); ++i) {
        const Point& p = body.points[i];
        if (p.V > 0 && p.V < 1e300) [[likely]]
            continue;
        std::ostringstream s;
        s << detail::place(i, p) << " has V/V0 = det F = " << p.V / p.V0;
        return {std::isfinite(p.V) ? "inverted-particle" : "not-finite", s.str()};
    }
    return {};
}

/// Where bodies are liveliest: the fastest of their particles, its speed, and its det F.
template <class Points> std::string fastest_particle(const Points& points) {
    if (points.size() == 0) return "no particles";
    std::size_t fastest = 0, i = 0;
    double speed2 = -1;
    for (const auto& p : points) {
        if (p.v.squaredNorm() > speed2) speed2 = p.v.squaredNorm(), fastest = i;
        ++i;
    }
    const auto& p = points[fastest];
    std::ostringstream s;
    s << detail::place(fastest, p) << " is the fastest, |v| = " << p.v.norm() << ", det F = " << p.V / p.V0;
    return s.str();
}

/// Energy that the balance kinetic + strain + dissipated - work cannot account for: growth by more than 5 % of the energy in play.
///
/// Kinetic and strain energy are known half a step apart, so that the sum of a stable vibration swings by sin(omega dt/2) of itself to
/// either side. It swings by more than 5 % only where a period has fewer than 126 steps, the swing 63: growth that stays through `patience`
/// steps is no swing, nor is growth beyond twice the largest, that of the shortest waves, nor, at any step, by half the energy in play.
class EnergyWatch {
public:
    /// `step_ratio` is dt over h/(c + |v|), which bounds omega dt/2.
    explicit EnergyWatch(double step_ratio) : certain_(std::min(limit + 2 * step_ratio, 0.5)) {}

    /// To be called at records and, while `suspicious`, at every step.
    Trouble check(const Measures& now, double work) {
        const double balance = now.balance() - work;
        if (first_) first_ = false, start_ = balance;
        in_play_ = std::max({in_play_, now.total(), std::abs(work)});
        growth_ = in_play_ > 0 ? (balance - start_) / in_play_ : 0;
        if (growth_ <= limit) return suspected_ = 0, Trouble{};
        if (growth_ < certain_ && ++suspected_ <= patience) return {};
        std::ostringstream s;
        s << "energy less work grew from " << start_ << " to " << balance << ", by " << 100 * growth_ << " % of the energy in play";
        return {std::isfinite(balance) ? "energy-growth" : "not-finite", s.str()};
    }
    bool suspicious() const { return suspected_ > 0; }
    double growth() const { return growth_; }
    double in_play() const { return in_play_; }
    static constexpr double limit = 0.05;
    static constexpr int patience = 63;

private:
    double certain_;
    int suspected_ = 0;  // steps with growth over the limit
    bool first_ = true;
    double start_ = 0, in_play_ = 0, growth_ = 0;
};

}  // namespace mpm
