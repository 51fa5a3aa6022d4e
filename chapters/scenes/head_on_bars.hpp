/// Two elastic bars meet head on (review 5.1): they press each other for 2L/c and part, equal ones with exchanged velocities.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/linear_elastic.hpp"
#include "lab/boundary.hpp"
#include "lab/contact_log.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"

namespace mpm {

struct BarsSettings {
    double E = 100, rho = 1, length = 1;              // modulus, density, length
    double v0 = 0.01, clearance = 0.001, ratio = 1;   // speed, gap, density of the right bar over that of the left one

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("rho", rho, "mass/length", above(0), "density");
        o.number("length", length, "length", above(0), "length of each bar");
        o.number("v0", v0, "length/time", above(0), "velocity of the left bar; the right one's is opposite");
        o.number("clearance", clearance, "length", at_least(0), "between the bars at the start");
        o.number("density-ratio", ratio, "-", above(0), "density of the right bar over that of the left one");
    }
};

/// Waves run from the faces to the free ends and back as relief: every point of the left bar has the velocity v0, v_face, 2 v_face - v0 in
/// turn, v_face = v0 (1 - z)/(1 + z) by the impedances rho c, z that of the right bar over that of the left one. A right bar that is
/// denser, and so slower, gets its relief later: the bars part at 2L/c of the left one; a lighter one is not followed. Small strains: the
/// law in rate form is that of the exact solution.
struct HeadOnBars : FreeScene, BarsSettings {
    static constexpr int D = 1;
    static constexpr const char* name = "head-on-bars";
    static constexpr const char* solves = "two elastic bars meet head on and part";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 5> columns{"v_left", "v_left_exact", "v_right", "friction", "impact"};
    using Law = LinearElastic;

    double t_end = 1;
    std::shared_ptr<ContactLog<1>> log = std::make_shared<ContactLog<1>>();

    HeadOnBars(const BarsSettings& settings, double end) : BarsSettings(settings), t_end(end) {}

    Law law() const { return {0, E / 2, rho * std::min(1.0, ratio)}; }  // the faster of both bars sets the step
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return v0; }
    double c() const { return std::sqrt(E / rho); }
    double meets() const { return clearance / (2 * v0); }
    double lasts() const { return 2 * length / c(); }
    bool has_exact() const { return ratio >= 1; }
    double v_face() const { return v0 * (1 - std::sqrt(ratio)) / (1 + std::sqrt(ratio)); }
    double v_end() const { return 2 * v_face() - v0; }  // of the left bar

    Lattice<1> lattice(int cells, int per_cell) const {
        const double h = length / cells, flight = std::ceil(v0 * t_end / h);
        if (!(flight < 1e6)) throw BadInput("--v0, --t-end: the bars fly over " + number_text(flight) + " cells, at most 1e6 are allowed");
        const int pad = 3 + static_cast<int>(flight), across = 2 * cells + static_cast<int>(std::ceil(clearance / h));
        return {Vec<1>(-length - pad * h), Vec<1>(h), {across + 2 * pad}, per_cell};
    }
    template <class Point> std::vector<std::vector<Point>> bodies(int cells, int ppc) const {
        const double l = length / cells / ppc;
        std::vector<Point> left, right;
        for (int i = 0; i < cells * ppc; ++i) {
            left.push_back(particle_at<Point>(Vec<1>(-length + (i + 0.5) * l), l, rho));
            right.push_back(particle_at<Point>(Vec<1>(clearance + (i + 0.5) * l), l, rho * ratio));
            left.back().v[0] = v0, right.back().v[0] = -v0;
        }
        return {left, right};
    }

    /// Mean velocity of the left bar: in a straight line while they touch.
    double exact(double t) const {
        if (!has_exact()) return std::numeric_limits<double>::quiet_NaN();
        return v0 + (v_end() - v0) * std::clamp((t - meets()) / lasts(), 0.0, 1.0);
    }
    /// Mean velocities by mass of the left and the right half of the particles.
    template <class Points> std::array<double, 2> means(const Points& points) const {
        std::array<double, 2> mv{}, m{};
        std::size_t i = 0;
        for (const auto& p : points) {
            const std::size_t side = 2 * i++ < points.size() ? 0 : 1;
            m[side] += p.m, mv[side] += p.m * p.v[0];
        }
        return {mv[0] / m[0], mv[1] / m[1]};
    }
    template <class Points> std::array<double, 5> watch(const Points& points, double t) const {
        const auto [left, right] = means(points);
        return {left, exact(t), right, log->friction, log->normal};
    }

    struct Observer {
        const HeadOnBars& scene;
        double left = 0, first = 0, energy = 0;

        template <class Points> void sample(const Points& points, double t, double now) {
            left = scene.means(points)[0];
            if (t == 0) first = now;
            if (!std::isnan(now)) energy = now;
        }
        bool wants_energy(double t, double t_end) const { return t == 0 || t >= t_end; }
        double duration() const { return scene.log->parted - scene.log->touched; }
        std::vector<NamedError> errors(double) const {
            if (!scene.has_exact()) return {{"duration", std::numeric_limits<double>::quiet_NaN()}};
            return {{"duration", std::abs(duration() / scene.lasts() - 1)},
                    {"touch", std::abs(scene.log->touched - scene.meets()) / scene.lasts()},
                    {"velocity", std::abs(left / scene.v_end() - 1)},
                    {"energy", std::abs(energy / first - 1)}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"bars touch at", scene.log->touched},
                    {"exact", scene.meets()},
                    {"contact lasts", duration()},
                    {"2L/c", scene.lasts()},
                    {"rebound speed / v0", -left / scene.v0},
                    {"energy kept", energy / first},
                    {"energy that normal impulses took", scene.log->normal}};
        }
    };
};

}  // namespace mpm
