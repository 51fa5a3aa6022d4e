/// What the run loop watches: energies, momentum, what flows in and out, and the signs that a run has become unstable.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "lab/body.hpp"

namespace mpm {

/// Sums over all bodies at one moment.
struct Measures {
    double kinetic = 0, strain = 0, dissipated = 0;  // energies
    std::array<double, 2> momentum{};                // components; the second is 0 in 1D
    double momentum_in_play = 0;                     // sum of m |v|
    double total() const { return kinetic + strain; }
    double balance() const { return kinetic + strain + dissipated; }
    void add(const Measures& part) {
        kinetic += part.kinetic, strain += part.strain, dissipated += part.dissipated;
        momentum_in_play += part.momentum_in_play;
        for (std::size_t d = 0; d < momentum.size(); ++d) momentum[d] += part.momentum[d];
    }
};

template <int D, class Point, class Node, class Law> void add_measures(const Matter<D, Point, Node, Law>& body, Measures& sum) {
    constexpr bool nodes_move = requires(const Node& node) { node.kinetic(); };  // finite elements: nodes hold the kinetic energy
    if constexpr (nodes_move)
        for (const Node& node : body.grid) sum.kinetic += node.kinetic();
    const auto add = [&](const Point& p, Measures& to) {
        const double v2 = p.v.squaredNorm();
        if constexpr (!nodes_move) to.kinetic += 0.5 * p.m * v2;
        to.strain += body.law.energy(p);
        if constexpr (requires { body.law.dissipated(p); }) to.dissipated += body.law.dissipated(p);
        to.momentum_in_play += p.m * std::sqrt(v2);
        for (int d = 0; d < D; ++d) to.momentum[static_cast<std::size_t>(d)] += p.m * p.v[d];
    };
    if constexpr (D == 1) {
        for (const Point& p : body.points) add(p, sum);
    } else {  // by pieces that no number of threads changes, and their sums one after the other
        const std::size_t piece = 4096, count = body.points.size();
        std::vector<Measures> sums((count + piece - 1) / piece);
        in_ranges(body.grid.threads(), sums.size(), [&](std::size_t k) {
            for (std::size_t i = k * piece; i < std::min(count, (k + 1) * piece); ++i) add(body.points[i], sums[k]);
        });
        for (const Measures& part : sums) sum.add(part);
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

    /// An impulse along an axis, of something that moves with v.
    void add(double along, int axis, double v) {
        impulse[static_cast<std::size_t>(axis)] += along;
        work += along * v;
    }
    Supply& operator+=(const Supply& other) {
        for (std::size_t d = 0; d < impulse.size(); ++d) impulse[d] += other.impulse[d];
        work += other.work;
        return *this;
    }
};

/// A named instability and the number that shows it.
struct Trouble {
    std::string cause;   // "" when all is well, else e.g. "energy-growth"
    std::string reason;  // one sentence
    explicit operator bool() const { return !cause.empty(); }
};

namespace detail {
template <class Point> std::string place(std::size_t number, const Point& p) {
    std::ostringstream s;
    s << "particle " << number << " at x = " << p.x.transpose();
    return s.str();
}
}  // namespace detail

/// The first particle that is turned inside out or not a number, or of which a law says `trouble(p)`. Positions are checked where weights
/// are made.
template <int D, class Point, class Node, class Law> Trouble check_particles(const Matter<D, Point, Node, Law>& body) {
    const auto bad = [&](std::size_t i) { return !(body.points[i].V > 0 && body.points[i].V < 1e300); };
    std::size_t first = first_where(body.grid.threads(), body.points.size(), bad);
    if (first == body.points.size()) {
        if constexpr (requires(const Point& p) { body.law.trouble(p); })
            for (std::size_t i = 0; i < body.points.size(); ++i)
                if (const Trouble t = body.law.trouble(body.points[i]))
                    return {t.cause, detail::place(body.number(i), body.points[i]) + " " + t.reason};
        return {};
    }
    for (std::size_t i = first + 1; i < body.points.size(); ++i)
        if (bad(i) && body.number(i) < body.number(first)) first = i;
    const Point& p = body.points[first];
    std::ostringstream s;
    s << detail::place(body.number(first), p) << " has V/V0 = det F = " << p.V / p.V0;
    return {std::isfinite(p.V) ? "inverted-particle" : "not-finite", s.str()};
}

/// Where bodies are liveliest: the fastest of their particles, its speed, and its det F. Bodies are pointers to Matter, their particles
/// numbered one body after the other.
template <class Bodies> std::string fastest_particle(const Bodies& bodies) {
    using Point = typename std::remove_cvref_t<decltype(*bodies.front())>::Point;
    const Point* fastest = nullptr;
    std::size_t number = 0, before = 0;
    for (const auto* body : bodies) {
        for (std::size_t i = 0; i < body->points.size(); ++i) {
            const double v2 = body->points[i].v.squaredNorm(), most = fastest ? fastest->v.squaredNorm() : 0;
            const std::size_t here = before + body->number(i);
            if (!fastest || v2 > most || (v2 == most && here < number)) fastest = &body->points[i], number = here;
        }
        before += body->points.size();
    }
    if (!fastest) return "no particles";
    const Point& p = *fastest;
    std::ostringstream s;
    s << detail::place(number, p) << " is the fastest, |v| = " << p.v.norm() << ", det F = " << p.V / p.V0;
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
