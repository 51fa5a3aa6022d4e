/// Two bars glued end to end and a wave that crosses the joint: particles on one side, finite elements on the other, or one kind alone.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/materials.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/rectilinear.hpp"

namespace mpm {

/// 0 < X < L, the joint in the middle, free ends. A pulse v0 cos^2 of half width `pulse` L starts before the joint; there it leaves R =
/// (z_1 - z_2)/(z_1 + z_2) of its velocity, T = 2 z_1/(z_1 + z_2) goes on, z = rho c. Uniaxial stress, lambda = 0; strains are v0/c. The
/// left bar is of finite elements, the right one of particles.
struct GluedBar {
    static constexpr int D = 1;
    static constexpr const char* name = "glued-bar";
    static constexpr const char* solves = "a pulse crosses the joint of a bar of finite elements and a bar of particles";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 4> columns{"momentum_left", "momentum_left_exact", "momentum_right", "momentum_right_exact"};
    using Law = Materials<NeoHookean>;

    double E = 1, rho = 1, length = 1, v0 = 1e-4, contrast = 1, rho_contrast = 1, pulse = 0.12;
    std::string bodies = "coupled", from = "fem";
    int cells = 200;
    double dt = 0;

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus of the bar in which the pulse starts");
        o.number("rho", rho, "mass/length", above(0), "its density");
        o.number("length", length, "length", above(0), "length of both bars together");
        o.number("v0", v0, "length/time", above(0), "amplitude of the pulse");
        o.number("contrast", contrast, "-", between(0.05, 4), "modulus of the other bar over the first one's");
        o.number("rho-contrast", rho_contrast, "-", between(0.25, 20), "density of the other bar over the first one's");
        o.number("pulse", pulse, "-", between(0.02, 0.12), "half width of the pulse over the length");
        o.choice("bodies", bodies, {"coupled", "fem", "mpm"}, "what the bar is made of: both, finite elements alone, particles alone");
        o.choice("from", from, {"fem", "mpm"}, "where the pulse starts: on the left, of finite elements, or on the right, of particles");
    }
    double c(int bar) const { return std::sqrt(bar == 0 ? E / rho : contrast * E / (rho_contrast * rho)); }
    double z(int bar) const { return c(bar) * (bar == 0 ? rho : rho_contrast * rho); }
    double R() const { return (z(0) - z(1)) / (z(0) + z(1)); }
    double T() const { return 2 * z(0) / (z(0) + z(1)); }
    double wave_speed() const { return std::max(c(0), c(1)); }
    double speed() const { return v0; }
    /// Both waves have left the joint, and none is at an end.
    double t_end() const { return 2.12 * pulse * length / c(0); }
    /// When the front of a wave meets an end of the bar: exact() knows no ends.
    double exact_until() const {
        const double joint = 0.1 * pulse * length / c(0), there = length / 2 / c(1), back = length / 2 / c(0);
        return joint + (R() == 0 ? there : std::min(there, back));
    }

    /// Of the bar left of the joint and right of it.
    int bar_at(double X) const { return (X < length / 2) == (from == "fem") ? 0 : 1; }
    NeoHookean law_of(int bar) const { return {0, (bar == 0 ? E : contrast * E) / 2, bar == 0 ? rho : rho_contrast * rho}; }
    Law law() const { return {{law_of(0), law_of(1)}}; }

    /// The pulse at the distance s from its middle: velocity over v0, its integral, its derivative.
    struct Pulse {
        double v = 0, u = 0, dv = 0;
    };
    Pulse at(double s) const {
        const double w = pulse * length, k = std::numbers::pi / w;
        if (s <= -w) return {};
        if (s >= w) return {0, w, 0};
        return {0.5 * (1 + std::cos(k * s)), 0.5 * (s + w + std::sin(k * s) / k), -0.5 * k * std::sin(k * s)};
    }
    /// Linear waves: displacement, velocity, acceleration, strain. y is the distance from the joint along the way of the pulse.
    struct State {
        double u = 0, v = 0, a = 0, strain = 0;
    };
    State exact(double X, double t) const {
        const double sign = from == "fem" ? 1 : -1, y = sign * (X - length / 2), start = -1.1 * pulse * length;
        State s;
        const auto add = [&](double amplitude, double c_bar, double along) {  // along: +1 the way of the pulse, -1 back
            const double scale = c(0) / c_bar, from_middle = c(0) * t - along * scale * y + start;
            const Pulse p = at(from_middle);
            s.u += amplitude * v0 * p.u / c(0);
            s.v += amplitude * v0 * p.v;
            s.a += amplitude * v0 * p.dv * c(0);
            s.strain -= sign * along * amplitude * v0 * p.v / c_bar;
        };
        if (y < 0)
            add(1, c(0), 1), add(R(), c(0), -1);
        else
            add(T(), c(1), 1);
        return s;
    }

    std::array<Lines, 1> lines(int n) const { return {even_lines(0, length * (1 + 4.0 / n), n + 4)}; }
    std::vector<char> held(const Rectilinear<1>& grid) const { return std::vector<char>(static_cast<std::size_t>(grid.size()), 0); }
    std::vector<char> reset_held(const Rectilinear<1>& grid) const {
        std::vector<char> all = held(grid);
        all.back() = 1;
        return all;
    }
    Vec<1> body_force(double) const { return Vec<1>(0); }
    Vec<1> fem_body_force(double) const { return Vec<1>(0); }
    Law fem_law() const { return law(); }
    int fem_material(const Vec<1>& X) const { return bar_at(X[0]); }
    /// Particles begin here.
    double joint() const { return bodies == "coupled" ? length / 2 : bodies == "fem" ? length : 0; }
    std::vector<int> fem_elements(const Rectilinear<1>& grid) const {
        std::vector<int> all;
        for (int e = 0; e < grid.elements(); ++e)
            if (grid.low(e, 0) + grid.size(e, 0) / 2 < joint()) all.push_back(e);
        return all;
    }
    template <class NodeState> void fem_start(const Vec<1>& X, NodeState& node) const {
        const State s = exact(X[0], 0);
        node.u[0] = s.u, node.v[0] = s.v, node.a[0] = s.a;
    }
    template <class Point> std::vector<Point> particles(int n, int ppc) const {
        const CellRule rule = middles(ppc);
        const double h = length / n;
        std::vector<Point> all;
        for (int cell = 0; cell < n; ++cell)
            for (std::size_t q = 0; q < rule.at.size() && (cell + 0.5) * h > joint(); ++q) {
                Point& p = all.emplace_back();
                p.X[0] = (cell + rule.at[q]) * h;
                const State s = exact(p.X[0], 0);
                p.material = bar_at(p.X[0]);
                p.V0 = rule.part[q] * h;
                p.m = law_of(p.material).rho * p.V0;
                p.x[0] = p.X[0] + s.u, p.v[0] = s.v, p.a[0] = s.a;
                p.F(0, 0) = 1 + s.strain;
                p.V = p.V0 * p.F(0, 0);
            }
        return all;
    }

    /// Velocities projected on those of the exact waves on both sides of the joint, over v0: amplitudes R and T once both have left it; the
    /// relative L2 error of the velocity.
    struct Seen {
        double reflected = 0, transmitted = 0, error = 0;
        std::array<double, 4> momentum{};  // left, exact, right, exact
    };
    template <class Points, class Other> Seen look(const Points& points, const Other& other, double t) const {
        std::array<double, 2> up{}, down{};
        double missing = 0, all = 0;
        Seen seen;
        const auto add = [&](const auto& p) {
            const double v = exact(p.X[0], t).v, sign = from == "fem" ? 1 : -1;
            const std::size_t side = sign * (p.X[0] - length / 2) < 0 ? 0 : 1;
            up[side] += p.m * p.v[0] * v, down[side] += p.m * v * v;
            missing += p.m * (p.v[0] - v) * (p.v[0] - v), all += p.m * v * v;
            const std::size_t right = p.X[0] < length / 2 ? 0 : 2;
            seen.momentum[right] += p.m * p.v[0], seen.momentum[right + 1] += p.m * v;
        };
        for (const auto& p : points) add(p);
        for (const auto* body : other)
            for (const auto& p : body->points) add(p);
        const auto amplitude = [&](std::size_t side, double exact_one) { return down[side] > 0 ? exact_one * up[side] / down[side] : 0; };
        seen.reflected = amplitude(0, R()), seen.transmitted = amplitude(1, T()), seen.error = std::sqrt(missing / all);
        return seen;
    }
    template <class Points, class Attached> std::array<double, 4> watch(const Points& points, const Attached& attached, double t) const {
        return look(points, attached.bodies(), t).momentum;
    }

    struct Observer {
        const GluedBar& bar;
        Seen end{};
        double first = 0, last = 0;

        template <class Points, class Attached> void sample(const Points& points, const Attached& attached, double t, double energy) {
            end = bar.look(points, attached.bodies(), t);
            if (t == 0) first = energy;
            last = energy;
        }
        bool wants_energy(double t, double t_end) const { return t == 0 || t >= t_end; }
        std::vector<NamedError> errors(double t_end) const {
            if (t_end > bar.exact_until()) return {{"velocity", std::numeric_limits<double>::quiet_NaN()}};
            return {{"velocity", end.error},
                    {"transmitted", std::abs(end.transmitted / bar.T() - 1)},
                    {"reflected", bar.R() == 0 ? 0 : std::abs(end.reflected / bar.R() - 1)}};
        }
        std::vector<std::pair<std::string, double>> facts(double t_end) const {
            if (t_end > bar.exact_until())
                return {{"a wave meets an end, none is exact from", bar.exact_until()},
                        {"energy at the end / start - 1", last / first - 1}};
            return {{"relative L2 error of the velocity", end.error},
                    {"transmitted amplitude", end.transmitted},
                    {"2 z_1/(z_1 + z_2)", bar.T()},
                    {"reflected amplitude", end.reflected},
                    {"(z_1 - z_2)/(z_1 + z_2)", bar.R()},
                    {"energy at the end / start - 1", last / first - 1}};
        }
    };
};

}  // namespace mpm
