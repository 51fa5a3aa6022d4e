/// A cantilever of a nearly incompressible solid in gravity that sets in at once, and how much its pressure oscillates.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/across.hpp"
#include "chapters/scenes/pressure_noise.hpp"
#include "lab/boundary.hpp"
#include "lab/figure.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"

namespace mpm {

/// What the command line says of the cantilever.
struct SuddenCantileverSettings {
    double E = 1e6, nu = 0.499, rho = 1000, gravity = 0.25, length = 4, height = 1;
    std::string fbar = "moving";
    bool total = false;  // total-Lagrangian: cells are those of the start

    void declare(Options& o) {
        o.choice("fbar", fbar, {"moving", "grid", "off"},
                 "volume changes averaged over the particles that start in a cell, that are in it now (Algorithm 7), or not at all");
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/area", above(0), "density");
        o.number("g", gravity, "length/time^2", above(0), "gravity, which sets in at once");
        o.number("length", length, "length", above(0), "length of the cantilever");
        o.number("height", height, "length", above(0), "height of the cantilever");
    }
    double mu() const { return E / (2 * (1 + nu)); }
    double lambda() const { return 2 * mu() * nu / (1 - 2 * nu); }
    double stiffness() const { return E / (1 - nu * nu) * height * height * height / 12; }  // E' I in plane strain

    /// Deflection of the tip at rest by Timoshenko's beam, shear factor 5/6. From rest the tip swings to twice that.
    double static_tip() const {
        const double q = rho * gravity * height, L2 = length * length;
        return q * L2 * L2 / (8 * stiffness()) + q * L2 / (2 * 5.0 / 6 * mu() * height);
    }
    /// Of the first bending mode, Euler and Bernoulli's beam.
    double period() const {
        const double beta = 1.875104068711961 / length;
        return 2 * std::numbers::pi / (beta * beta * std::sqrt(stiffness() / (rho * height)));
    }
};

/// The line x = 0 is held. `Law` has lambda, mu, rho and average(name).
template <class LawType> struct SuddenCantilever : SuddenCantileverSettings {
    static constexpr int D = 2;
    static constexpr const char* name = "cantilever";
    static constexpr const char* solves = "a nearly incompressible cantilever swings in gravity";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 4> columns{"tip", "tip_static", "noise_within", "noise_between"};
    using Law = LawType;

    int cells;

    SuddenCantilever(const SuddenCantileverSettings& s, int n) : SuddenCantileverSettings(s), cells(n) {
        const Lattice<2> grid = lattice(cells, 1);
        for (const int axis : {0, 1}) held_.hold_plane(grid, 0, 0, true, axis);
    }

    Law law() const {
        Law law;
        law.lambda = lambda(), law.mu = mu(), law.rho = rho;
        law.average(fbar);
        return law;
    }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return 0; }

    Lattice<2> lattice(int n, int per_cell) const {
        const double h = length / n, swing = std::ceil(3 * static_tip() / h);
        if (!(swing < 1e5)) throw BadInput("--g, --E: the tip swings over " + std::to_string(swing) + " cells, at most 1e5 are allowed");
        const int below = 3 + static_cast<int>(swing), across = std::max(1, static_cast<int>(std::lround(height / h)));
        return {Vec<2>(-3 * h, -below * h), Vec<2>::Constant(h), {n + 6, below + across + 3 + static_cast<int>(swing / 3)}, per_cell};
    }
    template <class Point> std::vector<Point> particles(int n, int ppc) const {
        std::vector<Point> all;
        const double part = length / n / ppc;
        const int rows = std::max(1, static_cast<int>(std::lround(height / part)));
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < n * ppc; ++i) {
                Point& p = all.emplace_back();
                p.X = p.x = Vec<2>(i + 0.5, j + 0.5) * part;
                p.V = p.V0 = part * part;
                p.m = rho * p.V;
            }
        return all;
    }

    template <class Body> void load(Body& body, double) const {
        for (auto& node : body.grid) node.f[1] -= node.m * gravity;
    }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const { held_.apply(grid, field); }
    template <class Bodies> Supply supply(const Bodies& bodies, double, double dt) const {
        Supply sum;
        for (const auto* body : bodies) {
            for (const auto& node : body->grid) sum.add(-dt * node.m * gravity, 1, node.v_new[1]);
            sum += held_.supply(body->grid, dt);
        }
        return sum;
    }

    /// Downward displacement of the right end: of its particles, on to the end with their F; the mean over the height.
    template <class Points> double tip(const Points& points) const {
        double last = 0, sum = 0, n = 0;
        for (const auto& p : points) last = std::max(last, p.X[0]);
        for (const auto& p : points)
            if (p.X[0] > last * (1 - 1e-9)) sum -= p.x[1] - p.X[1] + p.F(1, 0) * (length - p.X[0]), ++n;
        return sum / n;
    }
    /// A height away from the clamp, where its corners let no pressure be smooth, and from the free end.
    template <class Points> PressureNoise noise(const Points& points) const {
        const bool start = total || fbar == "moving";
        return pressure_noise(
            points, length / cells, height, length - height, [&](const auto& p) { return start ? p.X : p.x; },
            [&](const auto& p) { return volumetric_pressure(p, lambda()); });
    }
    template <class Points> std::array<double, 4> watch(const Points& points, double) const {
        const PressureNoise now = noise(points);
        return {tip(points), static_tip(), now.within, now.between};
    }
    Animated animated() const { return {"x", "y", "pressure", "x [length]", "y [length]", column_label("pressure")}; }

    struct Observer {
        const SuddenCantilever& scene;
        double peak = 0, t_peak = 0, t = 0, next = 0;
        PressureNoise sum{};
        int samples = 0;

        template <class Points> void sample(const Points& points, double now, double) {
            const double tip = scene.tip(points);
            t = now;
            if (tip > peak) peak = tip, t_peak = t;
            if (t < next) return;
            next += scene.period() / 100;
            if (t < scene.period() / 4) return;  // until the beam has bent, there is no pressure to compare with
            const PressureNoise at = scene.noise(points);
            sum.within += at.within, sum.between += at.between, ++samples;
        }
        bool wants_energy(double, double) const { return false; }
        PressureNoise mean() const { return {sum.within / samples, sum.between / samples}; }
        double reached() const { return peak / (2 * scene.static_tip()); }
        std::vector<NamedError> errors(double) const {
            return {{"peak", std::abs(reached() - 1)}, {"noise_within", mean().within}, {"noise_between", mean().between}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"first peak of the tip", peak},
                    {"at t / period", t_peak / scene.period()},
                    {"the same / (2 x Timoshenko)", reached()},
                    {"pressure noise within cells", mean().within},
                    {"pressure noise from cell to cell", mean().between}};
        }
    };

private:
    Dirichlet held_;
};

}  // namespace mpm
