/// The axially loaded column of the report (column_cases.hpp): one scene for its three cases, on the initial configuration.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "chapters/scenes/column_cases.hpp"
#include "chapters/scenes/column_exact.hpp"
#include "lab/boundary.hpp"
#include "lab/fill.hpp"
#include "lab/monitor.hpp"
#include "lab/norms.hpp"

namespace mpm {

/// For total-Lagrangian schemes, finite elements included: the grid is the column at rest.
template <class LawType>
struct Column : ColumnCase {
    static constexpr int D = 1;
    static constexpr const char* name = "column";
    static constexpr const char* reference = "exact";
    using Law = LawType;

    explicit Column(const ColumnCase& data) : ColumnCase(data) {}

    Law law() const { return {lambda(), mu(), rho}; }
    double speed() const { return largest_v0(); }
    /// P-wave of the column under its full load: the neo-Hookean solid stiffens when it is compressed (2.6 times the speed in case A).
    double wave_speed() const { return std::max(law().wave_speed(), std::sqrt(stiffness(law(), at_rest(law(), traction).F(0)) / rho)); }
    ColumnAtRest<Law> at_rest(const Law& l, double tau_now) const { return {l, length, tau_now, rho * gravity}; }

    Vec<1> initial_velocity(const Vec<1>& X) const { return Vec<1>(ColumnCase::initial_velocity(X[0])); }
    Lattice<1> lattice(int cells, int per_cell) const { return {Vec<1>(0.0), Vec<1>(length / cells), {cells}, per_cell}; }
    template <class Point>
    std::vector<Point> particles(int cells, int ppc) const {
        const CellRule rule = cell_rule(placing, ppc);
        const double h = length / cells;
        std::vector<Point> all;
        for (int cell = 0; cell < cells; ++cell)
            for (std::size_t q = 0; q < rule.at.size(); ++q) {
                Point& p = all.emplace_back();
                p.X[0] = p.x[0] = (cell + rule.at[q]) * h;
                p.V = p.V0 = area * rule.part[q] * h;
                p.m = rho * p.V;
                p.v = initial_velocity(p.X);
            }
        return all;
    }

    /// Gravity (report eq. 35: sum of phi m_p b = m_I b), traction (34) and damping. X* (33) is the end of the last particle and of the
    /// grid, where the last node's function is 1 and all others are 0, whichever they are: the traction acts on that node.
    template <class Body>
    void load(Body& body, double t) const {
        auto& grid = body.grid;
        for (auto& node : grid) node.f[0] += node.m * gravity;
        grid[grid.size() - 1].f[0] += area * tau(t);
        if (damping == 0) return;
        for (int I = 1; I < grid.size(); ++I) grid[I].f[0] += damping_force(std::abs(grid[I].f[0]), momentum(grid[I]));
    }
    template <class Grid, class Field>
    void fix(Grid& grid, Field field, double) const {
        (grid[0].*field)[0] = 0;
    }
    template <class Grid>
    Vec<1> held_force(const Grid& grid) const {
        return grid[0].f;
    }

    /// Impulse and work of the loads over the step from t, with the grid's velocities after it: those that move the particles and strain
    /// them. A leapfrog's work is the velocity times the mean of the forces at t and t + dt; of the damping only the force at t is known.
    /// What a transfer that is not all FLIP takes from the held node besides its force is not here: it shows as momentum unaccounted for.
    template <class Bodies>
    Supply supply(const Bodies& bodies, double t, double dt) const {
        Supply sum;
        const auto add = [&](double f_now, double f_next, double v) {
            sum.impulse[0] += dt * f_now;
            sum.work += dt * v * (f_now + f_next) / 2;
        };
        for (const auto* body : bodies) {
            const auto& grid = body->grid;
            add(area * tau(t), area * tau(t + dt), velocity_after(grid[grid.size() - 1]));
            for (const auto& node : grid) add(node.m * gravity, node.m * gravity, velocity_after(node));
            if (damping == 0) continue;
            for (int I = 1; I < grid.size(); ++I) {
                const double f = damping_part(grid[I], dt);
                add(f, f, velocity_after(grid[I]));
            }
        }
        return sum;
    }

    /// Displacement of the free end, from the last particle on with its own F.
    template <class Points>
    double u_end(const Points& points) const {
        const auto& p = points[points.size() - 1];
        return p.x[0] - p.X[0] + (p.F(0, 0) - 1) * (length - p.X[0]);
    }
    /// A quantity of the particles at X, linear between the two nearest: the report's averages over a node's particles (its Algorithm 2).
    template <class Points, class Value>
    double at(const Points& points, double X, Value&& value) const {
        std::size_t above = 1;
        while (above + 1 < points.size() && points[above].X[0] < X) ++above;
        const auto &b = points[above], &a = points[above - 1];
        const double part = (X - a.X[0]) / (b.X[0] - a.X[0]);
        return (1 - part) * value(a) + part * value(b);
    }
    double probe() const { return length / 10; }  // the report's node 1
    template <class Points>
    double sigma(const Points& points) const {
        return at(points, probe(), [](const auto& p) { return p.sigma(0, 0); });
    }

    template <class Points>
    std::vector<double> watch(const Points& points, double t) const {
        const double u_L = u_end(points);
        if (which == "C") return {u_L};
        if (which == "B") return {u_L, exact_u_end(t)};
        const Law l = law();
        const auto rest = at_rest(l, tau(t));
        const double u = at(points, probe(), [](const auto&p) { return p.x[0] - p.X[0]; }), s = sigma(points);
        const double F = at(points, probe(), [](const auto&p) { return p.F(0, 0); }), F_rest = rest.F(probe());
        // S = F^-1 P and P = sigma in one dimension; strains of Green, Almansi and Hencky (its equations 60, 61, 64)
        return {u_L,
                exact_u_end(t),
                u,
                rest.displacement(probe()),
                s,
                rest.stress(probe()),
                s / F,
                rest.stress(probe()) / F_rest,
                (F * F - 1) / 2,
                (1 - 1 / (F * F)) / 2,
                std::log(F)};
    }
    double exact_u_end(double t) const {
        const Law l = law();
        if (which == "A") return at_rest(l, tau(t)).displacement(length);
        return step_loaded(length, l.wave_speed() * t, length, traction / (l.lambda + 2 * l.mu));
    }

    /// Gathers what each case is judged by.
    struct Observer {
        const Column& column;
        double u_end = 0, sigma = 0, t = 0;
        double sum2 = 0;  // of differences to the series, over all steps
        long steps = 0;
        std::vector<double> energies{};  // at the start, at a quarter, at the end

        template <class Points>
        void sample(const Points& points, double now, double energy) {
            t = now;
            u_end = column.u_end(points);
            if (column.which == "A") sigma = column.sigma(points);
            if (column.which == "B") sum2 += std::pow(u_end - column.exact_u_end(t), 2), ++steps;
            if (!std::isnan(energy)) energies.push_back(energy);
        }
        bool wants_energy(double now, double t_end) const {
            if (column.which != "C") return false;
            return now == 0 || now >= t_end * (1 - 1e-12) || (energies.size() == 1 && now >= 0.25 * t_end * (1 - 1e-12));
        }
        double kept(std::size_t i) const {
            return i < energies.size() ? energies[i] / energies[0] : std::numeric_limits<double>::quiet_NaN();
        }
        double rms() const {
            return std::sqrt(sum2 / static_cast<double>(steps)) /
                   std::abs(column.traction * column.length / (column.law().lambda + 2 * column.law().mu));
        }
        double u_error() const { return u_end / column.exact_u_end(t) - 1; }
        double sigma_error() const {
            const Law l = column.law();
            return sigma / column.at_rest(l, column.tau(t)).stress(column.probe()) - 1;
        }

        std::vector<NamedError> errors(double) const {
            if (column.which == "A") return {{"u_static", std::abs(u_error())}, {"sigma_static", std::abs(sigma_error())}};
            if (column.which == "B") return {{"u_end_rms", rms()}};
            return {{"energy", std::abs(kept(2) - 1)}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            if (column.which == "A")
                return {{"displacement of the end", u_end},
                        {"the same / static - 1", u_error()},
                        {"stress at L/10", sigma},
                        {"the same / static - 1", sigma_error()}};
            if (column.which == "B") return {{"rms error of u(L) / |tau L/E|", rms()}};
            return {{"energy kept at t_end/4", kept(1)}, {"energy kept at the end", kept(2)}};
        }
    };

private:
    /// Local damping (review remark 19: Al-Kafaji 2013): a part of the out-of-balance force, against the motion. It vanishes at rest, so it
    /// does not change where the column comes to rest.
    double damping_force(double f, double mv) const { return mv == 0 ? 0 : -std::copysign(damping * f, mv); }
    /// What `load` added to a node's force, from what the node still knows after the step.
    template <class Node>
    double damping_part(const Node& node, double dt) const {
        double before = 0;  // momentum at t
        if constexpr (requires { node.mv; })
            before = node.mv[0];
        else
            before = node.mv_new[0] - dt * node.f[0];
        const double f = node.f[0], same_way = f * before > 0 ? 1 - damping : 1 + damping;
        return damping_force(std::abs(f) / same_way, before);
    }
    /// Momentum at the start of a step: finite elements keep it in the nodes.
    template <class Node>
    static double momentum(const Node& node) {
        if constexpr (requires { node.mv; })
            return node.mv[0];
        else
            return node.mv_new[0];
    }
    template <class Node>
    static double velocity_after(const Node& node) {
        if constexpr (requires { node.v_new; })
            return node.v_new[0];
        else
            return node.v[0];
    }
};

}  // namespace mpm
