/// An elastic disk flies at a rigid wall and rebounds (review 5.1.5, figure 48a).
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "lab/boundary.hpp"
#include "lab/contact_log.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"

namespace mpm {

/// What a slow impact would be: the disk's mass on the spring of a cylinder pressed against a rigid plane (Johnson, Contact Mechanics, 5.6:
/// half of the approach of two rigid planes that press it), without waves. Over the time in which a P-wave crosses the disk and
/// comes back it is good to some per cent.
struct SlowImpact {
    double duration = 0, depth = 0, force = 0;  // deepest approach of centre and plane, largest force per unit depth

    /// Approach of the disk's centre to the plane under the force F.
    static double approach(double F, double E, double nu, double R) {
        const double per_E = (1 - nu * nu) / E, a = std::sqrt(4 * F * R * per_E / std::numbers::pi);
        return F * per_E / std::numbers::pi * (2 * std::log(4 * R / a) - 1);
    }
    SlowImpact(double E, double nu, double rho, double R, double v0) {
        const double m = rho * std::numbers::pi * R * R, dt = 1e-4 * R / v0;
        double x = 0, v = v0, F = 0;
        while (x >= 0 && duration < 100 * R / v0) {  // leapfrog; the force by bisection: it grows with the approach
            double low = 0, high = E * R;
            for (int i = 0; i < 60; ++i) (approach(0.5 * (low + high), E, nu, R) < x ? low : high) = 0.5 * (low + high);
            F = x > 0 ? low : 0;
            v -= dt * F / m;
            x += dt * v;
            duration += dt;
            depth = std::max(depth, x), force = std::max(force, F);
        }
    }
};

/// The wall fills y < 0 at the start. The disk comes down; the wall may rise.
struct DiskOnWall : FreeScene {
    static constexpr int D = 2;
    static constexpr const char* name = "disk-on-wall";
    static constexpr const char* solves = "an elastic disk meets a rigid wall and rebounds";
    static constexpr const char* reference = "estimate";
    static constexpr std::array<const char*, 4> columns{"height", "speed", "speed_rigid", "spin"};
    static constexpr bool may_break = true;
    static constexpr double radius = 0.5;
    using Law = NeoHookean;

    double E = 1e6, nu = 0.3, rho = 1000, v0 = 1, along = 0, clearance = 0.02, wall_speed = 0, t_end = 0.4;
    std::string wall = "plane", placing = "rings";
    std::shared_ptr<ContactLog<2>> log = std::make_shared<ContactLog<2>>();

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = -1, .high = 0.5, .low_open = true, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/area", above(0), "density");
        o.number("v0", v0, "length/time", above(0), "speed of the disk, downwards");
        o.number("along", along, "length/time", any(), "speed of the disk along the wall");
        o.number("clearance", clearance, "length", at_least(0), "between disk and wall at the start");
        o.number("wall-speed", wall_speed, "length/time", any(), "speed of the wall, upwards");
        o.choice("wall", wall, {"plane", "particles"}, "an analytic plane, or rigid particles");
        o.choice("placing", placing, {"rings", "cells"}, "particles of the disk: in rings about its centre, or those of cells");
    }

    Law law() const {
        const double G = E / (2 * (1 + nu));
        return {2 * G * nu / (1 - 2 * nu), G, rho};
    }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return std::hypot(v0, along); }
    double closing() const { return v0 + wall_speed; }
    double touches() const { return clearance / closing(); }
    SlowImpact slow() const { return {E, nu, rho, radius, closing()}; }

    Lattice<2> lattice(int cells, int per_cell) const {
        const double h = 1.0 / cells, up = clearance + 1 + std::max(0.0, (v0 + 2 * std::abs(wall_speed)) * t_end);
        const double side = 0.6 + std::abs(along) * t_end, below = 0.2;
        if (!(std::max(up, side) * cells < 1e4)) throw BadInput("--v0, --along, --wall-speed: the disk flies over more than 1e4 cells");
        const int across = static_cast<int>(std::ceil(side * cells)) + 3, high = static_cast<int>(std::ceil(up * cells)) + 3;
        const int deep = static_cast<int>(std::ceil(below * cells)) + 2;
        return {Vec<2>(-across * h, -deep * h), Vec<2>::Constant(h), {2 * across, deep + high}, per_cell};
    }
    template <class Point> std::vector<std::vector<Point>> bodies(int cells, int ppc) const {
        const Vec<2> centre(0, clearance + radius);
        const double size = 1.0 / cells / ppc;
        std::vector<Point> disk = placing == "rings" ? rings<Point>(centre, radius, size, rho)
                                                     : particles_inside<Point>(Disk{centre, radius}, lattice(cells, 1), middles(ppc), rho);
        if (disk.empty()) throw BadInput("--cells, --ppc: no particle lies inside the disk");
        for (Point& p : disk) p.v = Vec<2>(along, -v0);
        return {disk};
    }

    struct State {
        double height = 0, speed = 0, spin = 0;
    };
    template <class Points> State state(const Points& points) const {
        double m = 0, J = 0, L = 0;
        Vec<2> x = Vec<2>::Zero(), v = x;
        for (const auto& p : points) m += p.m, x += p.m * p.x, v += p.m * p.v;
        x /= m, v /= m;
        for (const auto& p : points) {
            const Vec<2> r = p.x - x, w = p.v - v;
            J += p.m * r.squaredNorm(), L += p.m * (r[0] * w[1] - r[1] * w[0]);
        }
        return {x[1], v[1], L / J};
    }
    /// The velocity of a disk that rebounds at once, without loss, in the frame of the wall.
    template <class Points> std::array<double, 4> watch(const Points& points, double t) const {
        const State now = state(points);
        return {now.height, now.speed, t < touches() ? -v0 : v0 + 2 * wall_speed, now.spin};
    }
    struct Observer {
        const DiskOnWall& scene;
        State end{};
        double first = 0, energy = 0;
        template <class Points> void sample(const Points& points, double t, double now) {
            end = scene.state(points);
            if (t == 0) first = now;
            if (!std::isnan(now)) energy = now;
        }
        bool wants_energy(double t, double t_end) const { return t == 0 || t >= t_end; }
        double lasts() const { return scene.log->parted - scene.log->touched; }
        double rebound() const { return (end.speed - scene.wall_speed) / scene.closing(); }
        std::vector<NamedError> errors(double) const {
            return {{"rebound", std::abs(rebound() - 1)}, {"duration", std::abs(lasts() / scene.slow().duration - 1)}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            const SlowImpact slow = scene.slow();
            return {{"touches at", scene.log->touched},
                    {"exact", scene.touches()},
                    {"contact lasts", lasts()},
                    {"estimate without waves", slow.duration},
                    {"a P-wave crosses and comes back in", 4 * scene.radius / scene.wave_speed()},
                    {"rebound speed over the first", rebound()},
                    {"spin at the end", end.spin},
                    {"energy that friction took / first", scene.log->friction / first},
                    {"energy that normal impulses took / first", scene.log->normal / first}};
        }
    };
};

}  // namespace mpm
