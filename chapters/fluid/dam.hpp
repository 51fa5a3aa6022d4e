/// A column of water that breaks down in a box, with or without a barrier in its way (review 5.4.1, figures 53 and 54).
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "chapters/fluid/liquid.hpp"
#include "lab/boundary.hpp"
#include "lab/figure.hpp"
#include "lab/fill.hpp"
#include "lab/geometry.hpp"
#include "lab/norms.hpp"
#include "lab/record.hpp"

namespace mpm {

/// What the command line says, in SI units. The review prints neither kappa nor viscosity, nor where a barrier stands.
struct DamSettings : LiquidSettings {
    double box = 6, length = 4, height = 2, g = 9.81;  // side of the square box, column
    double barrier = 0, barrier_at = 5;                // height of the barrier, 0: none; its left side

    void declare(Options& o) {
        LiquidSettings::declare(o);
        o.number("box", box, "length", above(0), "side of the box; --cells go along it");
        o.number("length", length, "length", above(0), "of the column, which stands at the left wall");
        o.number("height", height, "length", above(0), "of the column");
        o.number("g", g, "length/time^2", above(0), "gravity");
        o.number("barrier", barrier, "length", at_least(0), "height of a barrier on the floor, at which water sticks; 0: none");
        o.number("barrier-at", barrier_at, "length", above(0), "where its left side is");
    }
    /// Throws BadInput for what does not fit into the box.
    void check() const {
        if (!(length < box)) throw BadInput("--length " + number_text(length) + ": less than --box " + number_text(box) + " is allowed");
        if (!(height < box)) throw BadInput("--height " + number_text(height) + ": less than --box " + number_text(box) + " is allowed");
        if (barrier > 0 && !(barrier_at > length && barrier_at < box))
            throw BadInput("--barrier-at " + number_text(barrier_at) + ": between --length and --box is allowed");
    }
};

/// The particles' middles lie in the column: on 70 cells with 2 x 2 particles 93 x 47 = 4371 of them, the review's number. They start
/// without pressure, as behind a gate that is taken away at once. Walls hold the normal velocity (of smooth functions: planes of symmetry).
/// The barrier is the nodes in a box two cells wide.
struct DamBreak : DamSettings {
    static constexpr int D = 2;
    static constexpr const char* name = "dam-break";
    static constexpr const char* solves = "a column of water breaks down in a box";
    static constexpr const char* reference = "incompressible";
    static constexpr std::array<const char*, 6> columns{"front", "T", "Z", "Z_shallow", "J_05", "J_95"};
    static constexpr bool may_break = true;  // water splashes
    using Law = Newtonian;

    double h = 1;  // [length]
    std::vector<SymmetryPlane<2>> walls{};
    Dirichlet obstacle{};

    DamBreak() = default;
    DamBreak(const DamSettings& settings, int cells) : DamSettings(settings), h(settings.box / cells) {
        const Lattice<2> grid = lattice(cells, 1);
        for (const int axis : {0, 1})
            for (const double x : {0.0, box}) walls.emplace_back(grid, axis, x);
        if (barrier <= 0) return;
        const Box stands{Vec<2>(barrier_at - 1e-9 * h, -h), Vec<2>(barrier_at + (2 + 1e-9) * h, barrier)};
        for (const int axis : {0, 1}) obstacle.hold_inside(grid, stands, axis);
    }

    Law law() const { return liquid(); }
    double wave_speed() const { return law().signal_speed(law().wave_speed(rho * g * height), h); }
    double speed() const { return std::sqrt(2 * g * height); }  // of water that falls from the top
    Animated animated() const { return {"x", "y", "speed", "x [m]", "y [m]", "speed [m/s]"}; }

    static constexpr int outside = 2;  // cells beyond each wall
    Lattice<2> lattice(int cells, int per_cell) const {
        const double size = box / cells;
        return {Vec<2>::Constant(-outside * size), Vec<2>::Constant(size), {cells + 2 * outside, cells + 2 * outside}, per_cell};
    }
    template <class Point> std::vector<Point> particles(int, int ppc) const {
        std::vector<Point> all;
        const double s = h / ppc;
        for (int j = 0; (j + 0.5) * s < height; ++j)
            for (int i = 0; (i + 0.5) * s < length; ++i) {
                Point& p = all.emplace_back();
                p.X = p.x = Vec<2>((i + 0.5) * s, (j + 0.5) * s);
                p.V0 = p.V = s * s;
                p.m = rho * p.V0;
            }
        if (all.empty()) throw BadInput("--cells, --ppc, --length, --height: no particle lies inside the column");
        return all;
    }

    template <class Body> void load(Body& body, double) const { gravity().load(body.grid); }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        for (const auto& wall : walls) wall.apply(grid, field);
        obstacle.apply(grid, field);
    }
    template <class Bodies> Supply supply(const Bodies& bodies, double, double dt) const {
        Supply sum;
        for (const auto* body : bodies) {
            sum += gravity().supply(body->grid, dt);
            sum += obstacle.supply(body->grid, dt);
            for (const auto& wall : walls) {
                const Vec<2> f = wall.held_force(body->grid);
                for (const std::size_t d : {0, 1}) sum.impulse[d] -= dt * f[static_cast<int>(d)];
            }
        }
        return sum;
    }

    /// How far the water has come: the edge of its foremost particle, taken as large as at the start.
    template <class Points> double front(const Points& points) const {
        double x = 0;
        for (const auto& p : points) x = std::max(x, p.x[0] + 0.5 * std::sqrt(p.V0));
        return x;
    }
    /// J that a part of the particles stays below.
    template <class Points> std::array<double, 2> densities(const Points& points) const {
        std::vector<double> J;
        for (const auto& p : points) J.push_back(p.V / p.V0);
        const auto at = [&](double part) {
            const auto place = J.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(J.size() - 1));
            std::nth_element(J.begin(), place, J.end());
            return *place;
        };
        return {at(0.05), at(0.95)};
    }
    /// Martin and Moyce's variables: T = t sqrt(n^2 g/a), Z = x/a with a the length of the column and n^2 its height over its length. The
    /// shallow-water front on a dry bed (Ritter), Z = 1 + 2 T, is the fastest there can be.
    double time_scale() const { return std::sqrt(g * height) / length; }
    template <class Points> std::array<double, 6> watch(const Points& points, double t) const {
        const auto [low, high] = densities(points);
        const double x = front(points), T = t * time_scale();
        return {x, T, x / length, 1 + 2 * T, low, high};
    }

    struct Observer {
        const DamBreak& scene;
        double lowest = 1, highest = 1, arrival = std::numeric_limits<double>::quiet_NaN(), x = 0;
        long steps = 0;

        template <class Points> void sample(const Points& points, double t, double) {
            if (steps++ % 20 != 0) return;
            const auto [low, high] = scene.densities(points);
            lowest = std::min(lowest, low), highest = std::max(highest, high);
            x = std::max(x, scene.front(points));
            if (std::isnan(arrival) && x > scene.box - scene.h) arrival = t;
        }
        bool wants_energy(double, double) const { return false; }
        std::vector<NamedError> errors(double) const { return {{"bulk_density", std::max(highest - 1, 1 - lowest)}}; }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"J that 5 % stay below, at its lowest", lowest},
                    {"J that 5 % stay above, at its highest", highest},
                    {"farthest front", x},
                    {"front within a cell of the wall at t", arrival}};
        }
    };

private:
    Gravity<2> gravity() const { return {Vec<2>(0, -g)}; }
};

}  // namespace mpm
