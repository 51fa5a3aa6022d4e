/// A free bar that flies through the grid while it vibrates: what a method loses or gains where particles change cells.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/rectilinear.hpp"

namespace mpm {

/// 0 < X < L, free at both ends; v = V + v0 cos(pi X/L), the first mode of a free bar. The linear bar keeps its energy and comes back to it
/// after every period 2 L/c. Nothing acts from outside.
struct FreeBar {
    static constexpr int D = 1;
    static constexpr const char* name = "free-bar";
    static constexpr const char* solves = "a free bar flies through the cells of the grid while it vibrates";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 6> columns{"vibration", "vibration_exact", "mode", "rms_dt_a", "x_cm", "x_cm_exact"};
    using Law = NeoHookean;

    double E = 100, rho = 1, length = 10, speed_ = 1, v0 = 1e-3, offset = 0;  // modulus, density, length, flight, amplitude, shift [cells]
    double crossings = 1000;                                                  // cells that the bar flies through
    int ppc = 2, cells = 20;
    double dt = 0;

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("rho", rho, "mass/length", above(0), "density");
        o.number("length", length, "length", above(0), "length of the bar");
        o.number("V", speed_, "length/time", above(0), "velocity of the flight");
        o.number("v0", v0, "length/time", at_least(0), "amplitude of the vibration's velocity; 0: only rounding disturbs the flight");
        o.number("offset", offset, "cells", between(-0.5, 0.5), "shift of all particles within their cells");
        o.number("crossings", crossings, "cells", between(0, 1e7), "cells that the bar flies through: end of the run");
    }
    Law law() const { return {0, E / 2, rho}; }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return speed_ + v0; }
    double h(int n) const { return length / n; }
    double t_end(int n) const { return std::max(crossings, 1e-3) * h(n) / speed_; }
    double period() const { return 2 * length / wave_speed(); }

    std::array<Lines, 1> lines(int n) const {
        const int ahead = static_cast<int>(crossings) + 6;
        return {even_lines(-3 * h(n), length + ahead * h(n), n + 3 + ahead)};
    }
    std::vector<char> held(const Rectilinear<1>& grid) const { return std::vector<char>(static_cast<std::size_t>(grid.size()), 0); }
    Vec<1> body_force(double) const { return Vec<1>(0); }
    template <class Point> std::vector<Point> particles(int n, int points) const {
        const CellRule rule = middles(points);
        std::vector<Point> all;
        for (int cell = 0; cell < n; ++cell)
            for (std::size_t q = 0; q < rule.at.size(); ++q) {
                Point& p = all.emplace_back();
                p.X[0] = (cell + rule.at[q]) * h(n);
                p.x[0] = p.X[0] + offset * h(n);
                p.V = p.V0 = rule.part[q] * h(n);
                p.m = rho * p.V;
                p.v[0] = speed_ + v0 * std::cos(std::numbers::pi * p.X[0] / length);
            }
        return all;
    }

    /// Velocity of the mode over v0 (over V without vibration), its exact value, amplitude of the mode from velocity and displacement; what
    /// the grid does not see of particles shows in dt a.
    template <class Points> std::array<double, 6> watch(const Points& points, double t) const {
        double v_mode = 0, u_mode = 0, shape2 = 0, a2 = 0, m = 0, mx = 0, mX = 0;
        for (const auto& p : points) {
            const double shape = std::cos(std::numbers::pi * p.X[0] / length);
            v_mode += p.m * (p.v[0] - speed_) * shape, shape2 += p.m * shape * shape;
            u_mode += p.m * (p.x[0] - p.X[0] - offset * h(cells) - speed_ * t) * shape;
            a2 += p.m * p.a.squaredNorm(), m += p.m, mx += p.m * p.x[0], mX += p.m * (p.X[0] + offset * h(cells));
        }
        const double unit = v0 > 0 ? v0 : speed_;
        const double exact = v0 > 0 ? std::cos(2 * std::numbers::pi * t / period()) : 0;
        const double amplitude = std::hypot(v_mode, u_mode * 2 * std::numbers::pi / period()) / shape2 / unit;
        return {v_mode / shape2 / unit, exact, amplitude, dt * std::sqrt(a2 / m) / unit, mx / m, mX / m + speed_ * t};
    }

    /// Energy without that of the flight, relative to its start.
    struct Observer {
        const FreeBar& bar;
        double first = 0, last = 0, most = 0, least = 1e300, path = 0;

        template <class Points> void sample(const Points& points, double t, double energy) {
            double m = 0, mv = 0;
            for (const auto& p : points) m += p.m, mv += p.m * p.v[0];
            last = energy - mv * mv / (2 * m);
            if (t == 0) first = last;
            most = std::max(most, last), least = std::min(least, last);
            const auto seen = bar.watch(points, t);
            path = seen[4] - seen[5];
        }
        bool wants_energy(double, double) const { return true; }
        const char* v0_text() const {
            return bar.v0 > 0 ? "vibration's energy at the end / start" : "vibration's energy at the end / flight's";
        }
        /// Without vibration: over the energy of the flight.
        double unit() const { return bar.v0 > 0 ? first : 0.5 * bar.rho * bar.length * bar.speed_ * bar.speed_; }
        std::vector<NamedError> errors(double) const {
            return {{"energy_gain", std::max(0.0, most - first) / unit()}, {"energy_end", std::abs(last - first) / unit()}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            const double start = first / unit();
            return {{v0_text(), start + (last - first) / unit()},
                    {"the same at most", start + (most - first) / unit()},
                    {"the same at least", start + (least - first) / unit()},
                    {"path of the centre - exact", path}};
        }
    };
};

}  // namespace mpm
