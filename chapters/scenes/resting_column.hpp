/// A column on the ground under its weight and a load on top, which set in at once or grow for a time; its state of rest is exact.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "chapters/scenes/column_exact.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/rectilinear.hpp"

namespace mpm {

/// Uniaxial strain of a neo-Hookean solid, fixed at X = 0; the load acts on the end of the last particle's part.
struct RestingColumn {
    static constexpr int D = 1;
    static constexpr const char* name = "resting-column";
    static constexpr const char* solves = "a column sinks under its weight and a load until it rests";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 2> columns{"u_end", "u_end_exact"};
    using Law = NeoHookean;

    double E = 1e8, nu = 0.3, rho = 1000, length = 10, g = 10, traction = -5e4;
    double stiffer = 1, ramp = 0;  // E, weight and load times this: the strain at rest stays; time in which they grow

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio (uniaxial strain)");
        o.number("rho", rho, "mass/length", above(0), "density");
        o.number("length", length, "length", above(0), "height of the column");
        o.number("g", g, "length/time^2", at_least(0), "gravity");
        o.number("traction", traction, "stress", any(), "load on top; negative presses");
        o.number("stiffer", stiffer, "-", above(0), "E, gravity and load times this: the same strain at rest, faster waves");
        o.number("ramp", ramp, "time", at_least(0), "time in which gravity and load grow; 0: at once");
    }
    double mu() const { return stiffer * E / (2 * (1 + nu)); }
    Law law() const { return {2 * mu() * nu / (1 - 2 * nu), mu(), rho}; }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return 0; }

    /// Finds the state of rest. Throws BadInput where the law cannot carry the load.
    void at_rest() {
        const Law solid = law();
        u_rest_ = rest(solid).displacement(length);
        if (u_rest_ > length) throw BadInput("--traction: the column stretches to more than twice its height");
    }
    template <class Solid> ColumnAtRest<Solid> rest(const Solid& solid) const { return {solid, length, stiffer * traction, -rho * stiffer * g}; }
    double grown(double t) const { return stiffer * (t < ramp ? t / ramp : 1); }

    std::array<Lines, 1> lines(int cells) const {
        const double h = length / cells;
        const int above = 2 + static_cast<int>(std::ceil(std::max(0.0, 2 * u_rest_) / h));
        return {even_lines(0, length + above * h, cells + above)};
    }
    std::vector<char> held(const Rectilinear<1>& grid) const {
        std::vector<char> all(static_cast<std::size_t>(grid.size()), 0);
        all[0] = 1;
        return all;
    }
    Vec<1> body_force(double t) const { return Vec<1>(-g * grown(t)); }

    struct Traction {
        std::size_t particle;
        Vec<1> x, force;
    };
    template <class Points> std::array<Traction, 1> tractions(const Points& points, double t) const {
        return {Traction{points.size() - 1, Vec<1>(end(points)), Vec<1>(traction * grown(t))}};
    }
    template <class Points> double end(const Points& points) const {
        const auto& p = points[points.size() - 1];
        return p.x[0] + p.F(0, 0) * (length - p.X[0]);
    }

    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        const CellRule rule = middles(ppc);
        const double h = length / cells;
        std::vector<Point> all;
        for (int cell = 0; cell < cells; ++cell)
            for (std::size_t q = 0; q < rule.at.size(); ++q) {
                Point& p = all.emplace_back();
                p.X[0] = p.x[0] = (cell + rule.at[q]) * h;
                p.V = p.V0 = rule.part[q] * h;
                p.m = rho * p.V;
            }
        return all;
    }
    template <class Points> std::array<double, 2> watch(const Points& points, double) const { return {end(points) - length, u_rest_}; }

    struct Observer {
        const RestingColumn& column;
        double u = 0, stress = 0, v = 0;
        template <class Points> void sample(const Points& points, double, double) {
            u = column.end(points) - column.length, stress = 0, v = 0;
            const Law solid = column.law();
            const auto rest = column.rest(solid);
            for (const auto& p : points) {  // in one dimension the nominal stress is sigma
                stress += p.V0 * std::pow(p.sigma(0, 0) - rest.stress(p.X[0]), 2) / column.length;
                v = std::max(v, std::abs(p.v[0]));
            }
        }
        bool wants_energy(double, double) const { return false; }
        double stress_error() const {
            return std::sqrt(stress) / (column.stiffer * (std::abs(column.traction) + column.rho * column.g * column.length));
        }
        std::vector<NamedError> errors(double) const {
            return {{"u_static", std::abs(u / column.u_rest_ - 1)}, {"sigma_static", stress_error()}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"displacement of the end", u},
                    {"the same at rest, exact", column.u_rest_},
                    {"the same / exact - 1", u / column.u_rest_ - 1},
                    {"rms error of the stress / that at the foot", stress_error()},
                    {"largest velocity left", v}};
        }
    };

private:
    double u_rest_ = 0;
};

}  // namespace mpm
