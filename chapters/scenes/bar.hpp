/// Axial vibration of a bar fixed at x = 0 and free at x = L (review 6.1.1): the scene of every bar program.
#pragma once
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "chapters/material/hooke.hpp"
#include "chapters/material/linear_elastic.hpp"
#include "lab/boundary.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"

namespace mpm {

/// Gathers v_cm and energy of a vibrating bar at every step; the headline errors of the run.
template <class Scene> struct WaveObserver {
    const Scene& bar;
    Oscillation wave{};

    template <class Points> void sample(const Points& points, double t, double energy) {
        wave.sample(t, bar.v_cm(points), bar.v_cm_exact(t), energy);
    }
    bool wants_energy(double t, double t_end) const { return t <= bar.period() || t >= t_end - bar.period(); }
    /// Frequency against the exact one; amplitude kept; and the relative L2 error of v_cm, which is near 1 for every stable variant
    /// after many periods, since a small frequency error has then put the phase out.
    std::vector<NamedError> errors(double t_end) const {
        return {{"frequency", std::abs(wave.omega() / bar.omega() - 1)},
                {"energy", std::abs(wave.energy_kept(bar.period(), t_end) - 1)},
                {"v_cm_L2", wave.relative_l2()},
                {"energy_per_period", drift(t_end)}};
    }
    /// Part of the energy that a period takes, or adds: the mean over all from the first to the last.
    double drift(double t_end) const {
        const double periods = t_end / bar.period() - 1;
        return periods > 0 ? std::abs(std::pow(wave.energy_kept(bar.period(), t_end), 1 / periods) - 1) : 0;
    }
    std::vector<std::pair<std::string, double>> facts(double t_end) const {
        return {{"frequency / exact - 1", wave.omega() / bar.omega() - 1},
                {"energy kept (last period / first)", wave.energy_kept(bar.period(), t_end)},
                {"relative L2 error of v_cm", wave.relative_l2()}};
    }
};

/// Mode n: v(x, 0) = v0 sin(beta x), beta = (2n - 1) pi/(2 L), omega = beta c (6.1)-(6.3). The velocity of the centre of mass is
///   v_cm(t) = cos(omega t) v0/L int_0^L sin(beta x) dx = v0/(beta L) [1 - cos(beta L)] cos(omega t) = v0/(beta L) cos(omega t),
/// since beta L is an odd multiple of pi/2: the sign is the same for every mode.
///
/// The law is linear in the configuration that the scheme works on: the rate form B.5 for updated-Lagrangian schemes, Hooke's law between P and F for
/// total-Lagrangian ones, so that each solves the linear wave equation to first order in the strain v0/c.
template <bool TotalLagrangian> struct Bar {
    static constexpr int D = 1;
    static constexpr const char* name = "bar";
    static constexpr const char* solves = "axial vibration of a bar, fixed at x = 0, free at x = L";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 2> columns{"v_cm", "v_cm_exact"};
    using Law = std::conditional_t<TotalLagrangian, Hooke, LinearElastic>;

    double E = 100, rho = 1, length = 25, v0 = 0.1, offset = 0;  // modulus, density, length, amplitude, shift in a cell
    int mode = 1;
    std::string placing = "mid";  // of particles: in the middles of equal parts of a cell, or "gauss"

    void declare(Options& o) {
        o.integer("mode", mode, "-", between(1, 1000), "number of the vibration mode");
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("rho", rho, "mass/length", above(0), "density");
        o.number("length", length, "length", above(0), "length of the bar");
        o.number("v0", v0, "length/time", above(0), "amplitude of the initial velocity");
        o.number("offset", offset, "cells", between(-0.5, 0.5), "shift of all particles within their cells");
    }

    double beta() const { return (2 * mode - 1) * std::numbers::pi / (2 * length); }
    double omega() const { return beta() * std::sqrt(E / rho); }
    double period() const { return 2 * std::numbers::pi / omega(); }
    double default_t_end() const { return 10 * (2 * length / std::sqrt(E / rho)) * 2; }  // 10 periods of mode 1: 100
    double speed() const { return v0; }  // largest particle speed, for the time step
    double v_cm_exact(double t) const { return v0 / (beta() * length) * std::cos(omega() * t); }
    double wave_speed() const { return law().wave_speed(); }
    Law law() const { return {0, E / 2, rho}; }  // lambda + 2 mu = E: uniaxial stress

    Vec<1> initial_velocity(const Vec<1>& X) const { return Vec<1>(v0 * std::sin(beta() * X[0])); }

    double cell_size(int cells) const { return length / cells; }

    /// A grid from the wall to the free end and, for updated-Lagrangian schemes, as far beyond it as the tip swings (v0/omega).
    Lattice<1> lattice(int cells, int per_cell) const { return swinging_lattice(cells, per_cell, 1.5 * v0 / omega()); }
    Lattice<1> swinging_lattice(int cells, int per_cell, double reach) const {
        const double h = cell_size(cells), swing = TotalLagrangian ? 0 : std::ceil(reach / h);
        if (!(swing < 1e7)) throw BadInput("--v0: the tip swings over " + std::to_string(swing) + " cells, at most 1e7 are allowed");
        const int pad = TotalLagrangian ? 0 : 2 + static_cast<int>(swing);
        return {Vec<1>(0), Vec<1>(h), {cells + pad}, per_cell};
    }

    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        const CellRule rule = cell_rule(placing, ppc);
        const double h = cell_size(cells);
        std::vector<Point> all;
        for (int cell = 0; cell < cells; ++cell)
            for (std::size_t q = 0; q < rule.at.size(); ++q) {
                Point& p = all.emplace_back();
                p.X[0] = p.x[0] = (cell + rule.at[q]) * h + offset * h;
                p.V = p.V0 = rule.part[q] * h;
                p.m = rho * p.V;
                p.v = initial_velocity(p.X);
            }
        return all;
    }

    template <class Body> void load(Body&, double) const {}
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const { (grid[0].*field)[0] = 0; }
    template <class Grid> Vec<1> held_force(const Grid& grid) const { return grid[0].f; }

    /// Velocity of the centre of mass (6.4).
    template <class Points> double v_cm(const Points& points) const {
        double m = 0, mv = 0;
        for (const auto& p : points) m += p.m, mv += p.m * p.v[0];
        return mv / m;
    }
    template <class Points> std::array<double, 2> watch(const Points& points, double t) const {
        return {v_cm(points), v_cm_exact(t)};
    }

    using Observer = WaveObserver<Bar>;
};

}  // namespace mpm
