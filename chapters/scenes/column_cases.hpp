/// The three verification cases of the report "A Dynamic Explicit Total Lagrangian MPM for Large Deformation in 1D" (sections IV.A to C).
#pragma once
#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "lab/figure.hpp"
#include "lab/options.hpp"

namespace mpm {

/// A column fixed at X = 0, with a traction at the other end and a body force; or one that starts with a given kinetic energy.
/// Defaults: case A. Any consistent units: SI in A and C, and g, mm, ms, hence MPa, in B.
struct ColumnCase {
    std::string which = "A", law = "neo-hookean", start = "uniform";
    std::string placing = "mid";         // of particles: in the middles of equal parts of a cell, or at Gauss points
    double E = 5e3, nu = 0.3, rho = 10;  // Young's modulus, Poisson's ratio, density
    double length = 0.1, area = 1e-4;
    double gravity = -9.81;            // body force per mass b, along X
    double traction = -1e4, ramp = 1;  // tau at X = L, and the time in which it grows; 0: at once
    double energy = 0;                 // kinetic energy at the start
    double damping = 0;                // local damping

    double mu() const { return E / (2 * (1 + nu)); }
    double lambda() const { return 2 * mu() * nu / (1 - 2 * nu); }
    double tau(double t) const { return ramp > 0 ? traction * std::min(t / ramp, 1.0) : traction; }
    /// From the energy m v^2/2 of the whole column (its equation 65 forgets the half). Every particle starts with the same energy in
    /// "uniform", a velocity jump at the fixed end; "smooth" is the first mode.
    double v0() const { return std::sqrt(2 * energy / (rho * area * length)); }
    double largest_v0() const { return start == "smooth" ? std::numbers::sqrt2 * v0() : v0(); }
    double initial_velocity(double X) const {
        return start == "smooth" ? largest_v0() * std::sin(std::numbers::pi * X / (2 * length)) : v0();
    }

    double period() const { return 4 * length * std::sqrt(rho / (lambda() + 2 * mu())); }  // of the first mode, at rest

    /// "a" and "A" are the same case.
    void name_case() { which[0] = static_cast<char>(std::toupper(which[0])); }
    std::string solves() const {
        if (which == "A") return "a column under slowly growing compression and its weight, fixed at X = 0";
        if (which == "B") return "a bar under a step load at its end, fixed at X = 0";
        return "a bar with an initial kinetic energy, fixed at X = 0, no load";
    }
    std::vector<std::string> columns() const {
        if (which == "A")
            return {"u_end", "u_end_exact", "u", "u_exact", "sigma", "sigma_exact", "S", "S_exact", "green", "almansi", "hencky"};
        if (which == "B") return {"u_end", "u_end_exact"};
        return {"u_end"};
    }

    /// What the figure of a run shows.
    std::vector<Panel> panels() const {
        const std::string computed = "lines dt solid lc rgb '#c03030'", other = "lines dt solid lc rgb '#3060c0'",
                          exact = "lines dt 2 lc rgb 'black'";
        Panel u{"", "t", "time t [time]", "u(L) [length]", {{"u_end", "computed", computed}}, ""};
        if (which != "C") u.curves.push_back({"u_end_exact", which == "A" ? "static" : "exact", exact});
        if (which != "A") return {u};
        const Panel stress{"",
                           "t",
                           "time t [time]",
                           "stress at L/10 [force/area]",
                           {{"sigma", "Cauchy σ", computed},
                            {"S", "2nd Piola-Kirchhoff S", other},
                            {"sigma_exact", "static", exact},
                            {"S_exact", "", exact}},
                           ""};
        return {u, stress};
    }

    void declare(Options& o) {
        constexpr double inf = std::numeric_limits<double>::infinity();
        const Range finite{.low = -inf, .high = inf};
        o.choice("case", which, {"A", "B", "C", "a", "b", "c"},
                 "A: quasi-static compression, B: step load, C: energy; the defaults are the case's");
        o.choice("law", law, {"neo-hookean", "hooke"}, "constitutive model; hooke: linear between P and F");
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio (no lateral displacement)");
        o.number("rho", rho, "mass/length^3", above(0), "density");
        o.number("length", length, "length", above(0), "length of the column");
        o.number("area", area, "length^2", above(0), "cross-section");
        o.number("gravity", gravity, "length/time^2", finite, "body force per mass, away from the fixed end");
        o.number("traction", traction, "stress", finite, "traction at the free end");
        o.number("ramp", ramp, "time", at_least(0), "time in which the traction grows; 0: at once");
        o.number("energy", energy, "force length", at_least(0), "kinetic energy at the start");
        o.choice("start", start, {"uniform", "smooth"}, "initial velocity: the same everywhere, or the first mode");
        o.number("damping", damping, "-", {.low = 0, .high = 1, .high_open = true},
                 "local damping: part of each node's force that opposes its velocity");
    }

    /// Refuses what the case's reference does not know. Throws BadInput.
    void check() const {
        const auto none = [&](double value, const char* option, const char* why) {
            if (value != 0) throw BadInput(std::string("--") + option + ": only 0 is allowed with --case " + which + ", " + why);
        };
        if (which == "A") return;
        const char* why = which == "B" ? "whose series knows a step load alone" : "whose energy is to be kept";
        none(gravity, "gravity", why);
        none(ramp, "ramp", why);
        none(damping, "damping", why);
        if (which == "B") none(energy, "energy", why);
        if (which == "C") none(traction, "traction", why);
        if (which == "C" && energy == 0) throw BadInput("--energy: case C needs one above 0");
    }
};

/// The parameters of its tables 69, 71, 72. Corrected there: in A the pseudo-time is a time in seconds, and node 1 is at L/10 = 0.01 m, not
/// 0.1; of C only a reading in SI makes sense (kg/m^3, m, s; E0 = 5e-5 J gives v0 = 1 m/s), and it runs to 0.2 as the text says, not 0.05.
/// The series of B is that of a linear bar, so B has the linear law, which the report does not: its neo-Hookean one stays 2 % off however
/// fine the grid (`--law neo-hookean`).
inline ColumnCase column_case(const std::string& which) {
    ColumnCase c;
    c.which = which;
    if (which == "A") return c;
    c.gravity = c.ramp = 0;
    if (which == "B") {
        c.law = "hooke";
        c.E = 250, c.nu = 0, c.rho = 1.9355e-3, c.length = 5, c.area = 19.635, c.traction = -1.27;
    } else {
        c.traction = 0;
        c.energy = 5e-5;
    }
    return c;
}

}  // namespace mpm
