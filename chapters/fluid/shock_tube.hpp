/// A tube of gas in two states that meet at a diaphragm (review 6.1.4, figure 65; Sod 1978): the Riemann problem on a finite length.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "chapters/fluid/ideal_gas.hpp"
#include "chapters/fluid/riemann.hpp"
#include "lab/boundary.hpp"
#include "lab/figure.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"

namespace mpm {

/// What the command line says of the tube. The defaults are Sod's problem.
struct TubeSettings {
    GasState left{1, 0, 1}, right{0.125, 0, 0.1};
    double gamma = 1.4, length = 1, diaphragm = 0.5, c0 = 2, c1 = 1;
    std::string energy = "centred";

    void declare(Options& o) {
        for (const auto& [side, state] : {std::pair{"left", &left}, std::pair{"right", &right}}) {
            const std::string name = side, gas = "of the gas on the " + name;
            o.number("rho-" + name, state->rho, "mass/length", at_least(0), "density " + gas + "; 0: vacuum");
            o.number("u-" + name, state->u, "length/time", any(), "velocity " + gas);
            o.number("p-" + name, state->p, "force", at_least(0), "pressure " + gas);
        }
        o.number("gamma", gamma, "-", {.low = 1, .high = 1000, .low_open = true}, "ratio of specific heats");
        o.number("length", length, "length", above(0), "length of the tube");
        o.number("diaphragm", diaphragm, "-", {.low = 0, .high = 1, .low_open = true, .high_open = true}, "its place / length");
        o.number("c0", c0, "-", at_least(0), "quadratic artificial viscosity");
        o.number("c1", c1, "-", at_least(0), "linear artificial viscosity");
        o.choice("energy", energy, {"centred", "end"}, "work of the mean stress of a step, or of the stress at its end (as printed)");
    }
    Riemann exact() const { return {left, right, gamma}; }
    double middle() const { return diaphragm * length; }

    /// Throws BadInput where there is nothing to solve, or where the waves come to the ends of the tube before t_end.
    void check(double t_end) const {
        if (left.rho <= 0 && right.rho <= 0) throw BadInput("--rho-left, --rho-right: one of them must be above 0");
        const Riemann solution = exact();
        const double room_left = left.rho > 0 ? middle() + solution.first() * t_end - std::max(0.0, left.u * t_end) : 1;
        const double room_right = right.rho > 0 ? length + std::min(0.0, right.u * t_end) - middle() - solution.last() * t_end : 1;
        if (!(room_left > 0 && room_right > 0))
            throw BadInput("--t-end " + number_text(t_end) + ": the waves reach an end of the tube before; --length or --diaphragm");
    }
};

/// The gas near an end of the tube moves as its state says, as before a piston where it comes in, so that nothing comes from there; on a
/// side without gas nothing is held. A particle has the state of the side where its middle starts.
struct ShockTube : TubeSettings {
    static constexpr int D = 1;
    static constexpr const char* name = "shock-tube";
    static constexpr const char* solves = "a shock tube: two states of a gas meet at a diaphragm";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 3> columns{"rho_max", "p_max", "v_max"};
    using Law = IdealGas;

    double h = 1, t_end = 0.143;  // [length], [time]

    ShockTube() = default;
    ShockTube(const TubeSettings& settings, int cells, double end) : TubeSettings(settings), h(settings.length / cells), t_end(end) {}

    Law law() const { return {gamma, c0, c1, h, energy == "centred" ? 0.5 : 1.0}; }
    /// The artificial viscosity is told of the largest jump of velocity between the states beside a wave.
    double wave_speed() const {
        const Riemann solution = exact();
        double jump = 0;
        if (!solution.vacuum())
            for (const GasState& side : {left, right}) jump = std::max(jump, std::abs(side.u - solution.u_star()));
        return law().signal_speed(solution.fastest_sound(), jump);
    }
    double speed() const { return exact().fastest_flow(); }
    Animated animated() const { return {"x", "rho", {}, "x [length]", "density [mass/length]", {}}; }

    /// The tube and the way of its ends and fronts, where they leave it.
    Lattice<1> lattice(int cells, int per_cell) const {
        const Riemann solution = exact();
        double low = std::min(0.0, left.u * t_end), high = length + std::max(0.0, right.u * t_end);
        if (left.rho <= 0) low = std::min(low, middle() + 1.05 * solution.first() * t_end);
        if (right.rho <= 0) high = std::max(high, middle() + 1.05 * solution.last() * t_end);
        const double below = std::ceil(-low / h - 1e-9), above = std::ceil((high - length) / h - 1e-9);
        if (!(below + above < 1e7)) throw BadInput("--u-left, --u-right, --t-end: the gas leaves the tube by more than 1e7 cells");
        const int pad_low = static_cast<int>(below), pad_high = static_cast<int>(above);
        return {Vec<1>(-pad_low * h), Vec<1>(h), {cells + pad_low + pad_high}, per_cell};
    }
    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        const CellRule rule = middles(ppc);
        std::vector<Point> all;
        for (int cell = 0; cell < cells; ++cell)
            for (const double at : rule.at) {
                const double x = (cell + at) * h;
                const GasState& state = x < middle() ? left : right;
                if (state.rho <= 0) continue;
                Point& p = all.emplace_back();
                p.X[0] = p.x[0] = x;
                p.V = p.V0 = h / ppc;
                p.m = state.rho * p.V;
                p.v[0] = state.u;
                law().start(p, state.rho, state.p);
            }
        if (all.empty()) throw BadInput("--cells, --diaphragm: no particle lies on the side with gas");
        return all;
    }

    template <class Body> void load(Body&, double) const {}
    template <class Grid, class Field> void fix(Grid& grid, Field field, double t) const {
        each_held(grid.lattice(), t, [&](int I, double u) { (grid[I].*field)[0] = grid[I].m * u; });
    }
    template <class Bodies> Supply supply(const Bodies& bodies, double t, double dt) const {
        Supply sum;
        for (const auto* body : bodies)
            each_held(body->grid.lattice(), t + dt, [&](int I, double u) { sum.add(held_impulse(body->grid[I], 0, u, dt), 0, u); });
        return sum;
    }

    template <class Points> std::array<double, 3> watch(const Points& points, double) const {
        double rho = 0, p_max = 0, v = 0;
        for (const auto& p : points) {
            rho = std::max(rho, p.rho);
            p_max = std::max(p_max, (gamma - 1) * p.rho * p.e);
            v = std::max(v, std::abs(p.v[0]));
        }
        return {rho, p_max, v};
    }

    /// What is judged is gathered at the end, with the nodes (gas_profile.hpp).
    struct Observer {
        const ShockTube& scene;
        template <class Points> void sample(const Points&, double, double) {}
        bool wants_energy(double, double) const { return false; }
        std::vector<NamedError> errors(double) const { return {}; }
        std::vector<std::pair<std::string, double>> facts(double) const { return {}; }
    };

private:
    static constexpr int held = 3;  // cells at each end

    template <class Visit> void each_held(const Lattice<1>& lattice, double t, Visit&& visit) const {
        const double low = std::max(0.0, left.u * t) + (held + 1e-9) * h, high = length + std::min(0.0, right.u * t) - (held + 1e-9) * h;
        for (int I = 0; I < lattice.size(); ++I) {
            const double x = lattice.position(I)[0];
            if (left.rho > 0 && x <= low) visit(I, left.u);
            else if (right.rho > 0 && x >= high) visit(I, right.u);
        }
    }
};

}  // namespace mpm
