/// A thick cylinder under inner pressure in plane strain: its data, and Lame's solution. The scene with domains: chapters/cpdi/cylinder.hpp.
#pragma once
#include <cmath>
#include <string>

#include "chapters/material/hooke.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"

namespace mpm {

/// What the command line says of the cylinder, and Lame's solution (small displacements; e.g. Timoshenko and Goodier, section 28).
struct CylinderCase {
    double a = 0.5, b = 1, p = 1e-3;        // inner and outer radius [length], inner pressure [stress]
    double E = 1000, nu = 0.3, rho = 1000;  // Young's modulus [stress], Poisson's ratio [-], density [mass/volume]
    double damping = 1;                     // part of the critical one of the breathing motion [-]
    std::string law = "neo-hookean", load_kind = "follower";

    void declare(Options& o) {
        o.number("inner", a, "length", above(0), "inner radius");
        o.number("outer", b, "length", above(0), "outer radius");
        o.number("pressure", p, "stress", {}, "inner pressure");
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = -1, .high = 0.5, .low_open = true, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/volume", above(0), "density");
        o.number("damping", damping, "-", at_least(0), "force against the motion, in parts of the breathing motion's critical damping");
        o.choice("law", law, {NeoHookean::name, Hooke::name}, "material");
        o.choice("load", load_kind, {"follower", "dead"}, "pressure on the edges as they are, or as they were at the start");
    }
    /// Throws BadInput for a cylinder without a wall or without a pressure.
    void check() const {
        if (a >= b) throw BadInput("--inner = " + number_text(a) + ": allowed < --outer = " + number_text(b));
        if (p == 0) throw BadInput("--pressure = 0: allowed any other, errors are relative to what it does");
    }

    double lambda() const { return E * nu / ((1 + nu) * (1 - 2 * nu)); }
    double mu() const { return E / (2 * (1 + nu)); }
    /// Breathing of a thin ring with the mean radius [1/time]; a thick one's is not far from it.
    double omega() const { return std::sqrt(E / ((1 - nu * nu) * rho)) / ((a + b) / 2); }
    /// Twenty times 1/omega: of a critically damped motion 21 exp(-20) = 4e-8 are left.
    double time_to_rest() const { return 20 / omega(); }

    double scale() const { return p * a * a / (b * b - a * a); }
    double radial(double r) const { return scale() * (1 - b * b / (r * r)); }
    double hoop(double r) const { return scale() * (1 + b * b / (r * r)); }
    double displacement(double r) const { return scale() * (1 + nu) / E * ((1 - 2 * nu) * r + b * b / r); }
};

}  // namespace mpm
