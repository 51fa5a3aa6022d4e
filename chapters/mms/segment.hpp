/// The axis-aligned unit segment (review 6.2.1): a bar held at both ends whose body force makes it move as manufactured (motion.hpp).
#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "chapters/mms/motion.hpp"
#include "chapters/mms/norms.hpp"
#include "lab/boundary.hpp"
#include "lab/fill.hpp"
#include "lab/monitor.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"

namespace mpm {

/// `TotalLagrangian` schemes, finite elements included, weigh their errors with V0, the others with V (end of A.2). No particle leaves
/// [0, 1]: no padding.
template <bool TotalLagrangian> struct Segment : SegmentMotion {
    static constexpr int D = 1;
    static constexpr const char* name = "segment";
    static constexpr const char* solves = "manufactured vibration of a unit segment, held at both ends";
    static constexpr const char* reference = "manufactured";
    static constexpr std::array<const char*, 2> columns{"v_cm", "v_cm_exact"};
    using Law = NeoHookean;

    std::string placing = "mid";      // of particles: in the middles of equal parts of a cell, or at Gauss points
    std::string force = "particles";  // where the body force acts: m_p b(X_p) mapped to the nodes, or m_I b(X_I)

    void declare(Options& o) {
        o.number("G", G, "length", above(0), "largest displacement; the segment has length 1");
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/length", above(0), "density");
        o.integer("mode", mode, "-", between(1, 1000), "half waves along the segment");
        o.choice("force", force, {"particles", "nodes"}, "where the body force acts");
        o.choice("points", placing, {"mid", "gauss"}, "particles in the middles of equal parts of a cell, or at Gauss points");
    }
    /// Throws BadInput for a motion that would turn the segment inside out.
    void check() const {
        if (k_pi() * G >= 1)
            throw BadInput("--G = " + std::to_string(G) + ": allowed with --mode " + std::to_string(mode) + " < " +
                           std::to_string(1 / k_pi()));
    }

    double speed() const { return omega() * G; }
    double wave_speed() const { return law().wave_speed(); }
    Law law() const { return {lambda(), mu(), rho}; }
    Vec<1> initial_velocity(const Vec<1>& X) const { return Vec<1>(v(X[0], 0)); }
    Lattice<1> lattice(int cells, int per_cell) const { return {Vec<1>(0.0), Vec<1>(1.0 / cells), {cells}, per_cell}; }

    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        const CellRule rule = cell_rule(placing, ppc);
        std::vector<Point> all;
        for (int cell = 0; cell < cells; ++cell)
            for (std::size_t q = 0; q < rule.at.size(); ++q) {
                Point& p = all.emplace_back();
                p.X[0] = p.x[0] = (cell + rule.at[q]) / cells;
                p.V = p.V0 = rule.part[q] / cells;
                p.m = rho * p.V;
                p.v = initial_velocity(p.X);
            }
        return all;
    }

    /// Where the material at node I started: total-Lagrangian grids do not move with it.
    double start_of(const Lattice<1>& grid, int I, double t) const {
        const double x = grid.position(I)[0];
        return TotalLagrangian ? x : X_of(x, t);
    }
    template <class Body> void load(Body& body, double t) const {
        if (force == "particles") {
            scatter(body, [&](const auto& p, const auto& weights) {
                const double f = p.m * b(p.X[0], t);
                for (const auto& [node, phi, grad] : weights) node.f[0] += phi * f;
            });
        } else {
            for (int I = 0; I < body.grid.size(); ++I) body.grid[I].f[0] += body.grid[I].m * b(start_of(body.grid.lattice(), I, t), t);
        }
    }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        (grid[0].*field)[0] = 0;
        (grid[grid.size() - 1].*field)[0] = 0;
    }
    template <class Grid> Vec<1> held_force(const Grid& grid) const { return grid[0].f + grid[grid.size() - 1].f; }

    /// Impulse and work of the body force over the step from t, with the velocities after it. A leapfrog's work is the force at t times
    /// the mean of the velocities half a step before and after; summed over the steps that is the velocity times the mean of the forces
    /// at t and t + dt.
    template <class Bodies> Supply supply(const Bodies& bodies, double t, double dt) const {
        Supply sum;
        const auto add = [&](double m, double mv, double b_now, double b_next) {
            sum.impulse[0] += dt * m * b_now;
            sum.work += dt * mv * (b_now + b_next) / 2;
        };
        for (const auto* body : bodies) {
            const auto& grid = body->grid;
            if (force == "particles")
                for (const auto& p : body->points) add(p.m, p.m * p.v[0], b(p.X[0], t), b(p.X[0], t + dt));
            else
                for (int I = 0; I < grid.size(); ++I) {
                    const double here = start_of(grid.lattice(), I, t), next = start_of(grid.lattice(), I, t + dt);
                    add(grid[I].m, grid[I].mv_new[0], b(here, t), b(next, t + dt));
                }
        }
        return sum;
    }

    /// Velocity of the centre of mass and what it should be, c G (1 - cos(k pi)) cos(omega t).
    template <class Points> std::array<double, 2> watch(const Points& points, double t) const {
        double m = 0, mv = 0;
        for (const auto& p : points) m += p.m, mv += p.m * p.v[0];
        return {mv / m, omega() * G * (1 - std::cos(k_pi())) / k_pi() * std::cos(omega() * t)};
    }

    struct Observer {
        const Segment& segment;
        DisplacementError norms{};

        template <class Points> void sample(const Points& points, double t, double) {
            const auto exact = [&](const auto& p) { return Vec<1>(segment.u(p.X[0], t)); };
            norms.sample(points, exact, [](const auto& p) { return TotalLagrangian ? p.V0 : p.V; });
        }
        bool wants_energy(double, double) const { return false; }
        std::vector<NamedError> errors(double) const { return {{"e1", norms.e1()}, {"e2", norms.e2()}, {"rmse", norms.rmse()}}; }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"largest rms error in time, e1", norms.e1()},
                    {"relative error over time, e2", norms.e2()},
                    {"rms over time (6.7)", norms.rmse()}};
        }
    };
};

}  // namespace mpm
