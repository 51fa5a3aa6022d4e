/// A bar that flies through the grid, freely or into a wall: bodies smaller than a cell, and impact slower and faster than sound.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "lab/boundary.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"

namespace mpm {

/// What the command line says of the bar.
struct FlyingBarCase {
    double E = 100, rho = 1, length = 1, mach = 0.1, size = 0, offset = 0, strain = 0, crossings = 20;
    std::string into = "wall";

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("rho", rho, "mass/length", above(0), "density");
        o.number("length", length, "length", above(0), "what --cells divide; the bar's length unless --size is given");
        o.number("mach", mach, "-", above(0), "speed of the bar over its speed of sound");
        o.choice("into", into, {"wall", "nothing"}, "it strikes a wall at x = 0, or flies freely");
        o.number("size", size, "cells", at_least(0), "length of the bar, which may be less than a cell; 0: --length");
        o.number("offset", offset, "cells", between(-0.5, 0.5), "of --into nothing: shift of the bar against the grid");
        o.number("strain", strain, "-", between(-0.9, 10), "of --into nothing: stretch - 1 at the start, uniform; the bar vibrates");
        o.number("crossings", crossings, "cells", between(0.1, 1e6), "of --into nothing: cells that the bar flies through");
    }
    /// Throws BadInput for what does not go together.
    void check(const Options& o) const {
        for (const char* name : {"offset", "strain", "crossings"})
            if (into == "wall" && o.given(name)) throw BadInput(std::string("--") + name + ": only with --into nothing, not wall");
    }
    NeoHookean law() const { return {0, E / 2, rho}; }
    double c() const { return law().wave_speed(); }
    double speed() const { return mach * c(); }
    bool strikes() const { return into == "wall"; }
};

/// Into the wall: a shock runs from it through the bar, which comes to rest behind it. With the bar's law, P = E/2 (F - 1/F), balance
/// of mass and momentum across the shock, U (1 - F) = V and rho U V = -P, give 2 (V/c)^2 F = (1 - F)^2 (1 + F) for the stretch F behind it;
/// so the mean velocity falls as V (1 - U t/L) until the shock leaves. The shock dissipates; methods without viscosity keep that energy as
/// oscillations behind it.
///
/// Freely: the centre of mass keeps its velocity, and no particle is ever strained by more than at the start.
template <bool TotalLagrangian> struct FlyingBar : FlyingBarCase {
    static constexpr int D = 1;
    static constexpr const char* name = "flying-bar";
    static constexpr const char* solves = "a bar flies freely or into a wall";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 4> columns{"v_cm", "v_cm_exact", "J_min", "J_max"};
    using Law = NeoHookean;

    int cells = 1;

    FlyingBar(const FlyingBarCase& options, int number) : FlyingBarCase(options), cells(number) {}

    /// Of the bar behind the shock, whose waves in the undeformed bar, where total-Lagrangian grids are, run with rho c^2 = dP/dF.
    double wave_speed() const {
        const double F = TotalLagrangian && strikes() ? shocked() : 1;
        return c() * std::sqrt(0.5 * (1 + 1 / (F * F)));
    }
    double h() const { return length / cells; }
    double body() const { return size > 0 ? size * h() : length; }  // the bar's length
    /// Stretch behind the shock, by bisection: (1 - F)^2 (1 + F)/F falls from infinity to 0.
    double shocked() const {
        double low = 0, high = 1;
        for (int i = 0; i < 200; ++i) {
            const double F = 0.5 * (low + high);
            ((1 - F) * (1 - F) * (1 + F) > 2 * mach * mach * F ? low : high) = F;
        }
        return 0.5 * (low + high);
    }
    double shock_speed() const { return speed() / (1 - shocked()); }  // of the undeformed bar
    double default_t_end() const { return strikes() ? 0.8 * body() / shock_speed() : crossings * h() / speed(); }

    Lattice<1> lattice(int, int per_cell) const {
        const double across = std::ceil(body() / h()) + (strikes() || TotalLagrangian ? 0 : std::ceil(crossings));
        if (!(across < 1e7)) throw BadInput("--size, --crossings: a grid of " + number_text(across) + " cells, at most 1e7 are allowed");
        const int before = strikes() ? 0 : 3;
        return {Vec<1>(-before * h()), Vec<1>(h()), {static_cast<int>(across) + before + 3}, per_cell};
    }
    template <class Point> std::vector<Point> particles(int, int ppc) const {
        const int n = std::max(1, static_cast<int>(std::lround(ppc * body() / h())));
        const double l = body() / n, stretch = 1 + strain;
        std::vector<Point> all;
        for (int i = 0; i < n; ++i) {
            Point& p = all.emplace_back();
            p.X[0] = p.x[0] = (i + 0.5) * l + offset * h();
            p.F *= stretch;
            p.V0 = l / stretch, p.V = l;
            p.m = rho * p.V0;
            p.v[0] = strikes() ? -speed() : speed();
            law().update(p, identity<1>(), 0);
        }
        return all;
    }
    template <class Body> void load(Body&, double) const {}
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        if (strikes()) on_wall(grid, [&](int I) { (grid[I].*field)[0] = 0; });
    }
    template <class Grid> Vec<1> held_force(const Grid& grid) const {
        Vec<1> sum = Vec<1>::Zero();
        if (strikes()) on_wall(grid, [&](int I) { sum += grid[I].f; });
        return sum;
    }

    double v_exact(double t) const {
        return strikes() ? -speed() * (1 - std::clamp(shock_speed() * t / body(), 0.0, 1.0)) : speed();
    }
    template <class Points> std::array<double, 4> watch(const Points& points, double t) const {
        double m = 0, mv = 0, least = std::numeric_limits<double>::infinity(), most = 0;
        for (const auto& p : points) {
            m += p.m, mv += p.m * p.v[0];
            least = std::min(least, p.V / p.V0), most = std::max(most, p.V / p.V0);
        }
        return {mv / m, v_exact(t), least, most};
    }

    struct Observer {
        const FlyingBar& bar;
        double error2 = 0, strain = 0;
        long samples = 0;

        template <class Points> void sample(const Points& points, double t, double) {
            const auto [v, exact, least, most] = bar.watch(points, t);
            error2 += (v - exact) * (v - exact), ++samples;
            strain = std::max({strain, most - 1, 1 - least});
        }
        bool wants_energy(double, double) const { return false; }
        double v_cm() const { return std::sqrt(error2 / static_cast<double>(samples)) / bar.speed(); }
        /// Mean velocity, root mean square over time, in parts of the speed; freely also the largest strain beyond that at the start.
        std::vector<NamedError> errors(double) const {
            if (bar.strikes()) return {{"v_cm", v_cm()}};
            return {{"strain", std::max(0.0, strain - std::abs(bar.strain))}, {"v_cm", v_cm()}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            std::vector<std::pair<std::string, double>> all{{"mean velocity - exact, rms / speed", v_cm()}, {"largest strain", strain}};
            if (bar.strikes())
                all.insert(all.end(),
                           {{"stretch behind the shock, exact", bar.shocked()}, {"shock speed / c", bar.shock_speed() / bar.c()}});
            return all;
        }
    };

private:
    /// Nodes at x = 0 and beyond it.
    template <class Grid, class Visit> void on_wall(const Grid& grid, Visit&& visit) const {
        for (int I = 0; I < grid.size() && grid.lattice().position(I)[0] < 1e-9 * h(); ++I) visit(I);
    }
};

}  // namespace mpm
