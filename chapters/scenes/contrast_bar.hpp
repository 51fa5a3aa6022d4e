/// A bar of two halves, the outer one stiffer or softer, fixed at x = 0 and free at x = L: the axial vibration of review 6.1.1 with a jump
/// in E.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "chapters/material/materials.hpp"
#include "chapters/scenes/bar.hpp"

namespace mpm {

/// First mode. With a = omega L/(2 c_1), b = omega L/(2 c_2): v = A sin(2 a x/L) in the inner half, B cos(2 b (L - x)/L) in the outer one;
/// equal velocities and stresses in the middle, A sin a = B cos b and E_1 (a) A cos a = E_2 (b) B sin b, ask for tan a tan b =
/// sqrt(E_1/E_2). `v0` is the velocity of the end, B.
template <bool TotalLagrangian> struct ContrastBar : Bar<TotalLagrangian> {
    static constexpr const char* name = "contrast-bar";
    static constexpr const char* solves = "first axial vibration of a bar whose halves differ in stiffness, fixed at x = 0, free at x = L";
    using Law = Materials<typename Bar<TotalLagrangian>::Law>;
    using Bar<TotalLagrangian>::E, Bar<TotalLagrangian>::rho, Bar<TotalLagrangian>::length, Bar<TotalLagrangian>::v0;

    double contrast = 1;  // E of the outer half over E of the inner one [-]
    int outer_ppc = 0;    // particles per cell of the outer half; 0: as in the inner one

    void declare(Options& o) {
        o.number("contrast", contrast, "-", above(0), "modulus of the outer half over that of the inner one");
        o.number("E", E, "stress", above(0), "Young's modulus of the inner half");
        o.number("rho", rho, "mass/length", above(0), "density");
        o.number("length", length, "length", above(0), "length of the bar");
        o.number("v0", v0, "length/time", above(0), "initial velocity of the free end");
        o.number("offset", this->offset, "cells", between(-0.5, 0.5), "shift of all particles within their cells");
        o.integer("outer-ppc", outer_ppc, "-", between(0, 100), "particles per cell of the outer half; 0: --ppc, as in the inner one");
    }

    /// a of the first mode: tan a tan(a r) - r grows from -r to infinity over 0 < a < pi/2 min(1, 1/r), r = sqrt(E_1/E_2).
    double a() const {  // asked at every step, and solved once
        if (solved_for_ != contrast) root_ = solved_a(), solved_for_ = contrast;
        return root_;
    }
    double solved_a() const {
        const double r = std::sqrt(1 / contrast);
        double low = 0, high = std::numbers::pi / 2 * std::min(1.0, 1 / r);
        for (int i = 0; i < 200; ++i) {
            const double middle = 0.5 * (low + high);
            (std::tan(middle) * std::tan(middle * r) < r ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }
    double b() const { return a() / std::sqrt(contrast); }
    double omega() const { return 2 * a() / length * std::sqrt(E / rho); }
    double period() const { return 2 * std::numbers::pi / omega(); }
    double velocity(double X) const {
        const double s = 2 * X / length;
        return s < 1 ? v0 * std::cos(b()) / std::sin(a()) * std::sin(a() * s) : v0 * std::cos(b() * (2 - s));
    }
    double v_cm_exact(double t) const {
        const double inner = std::cos(b()) / std::sin(a()) * (1 - std::cos(a())) / a(), outer = std::sin(b()) / b();
        return v0 / 2 * (inner + outer) * std::cos(omega() * t);
    }
    Law law() const { return {{{0, E / 2, rho}, {0, contrast * E / 2, rho}}}; }
    double wave_speed() const { return law().wave_speed(); }

    Lattice<1> lattice(int cells, int per_cell) const { return this->swinging_lattice(cells, per_cell, 1.5 * v0 / omega()); }
    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        auto points = Bar<TotalLagrangian>::template particles<Point>(cells, ppc);
        if (outer_ppc > 0 && outer_ppc != ppc) {
            const auto inner = [&](const Point& p) { return p.X[0] < length / 2; };
            std::erase_if(points, [&](const Point& p) { return !inner(p); });
            for (const Point& p : Bar<TotalLagrangian>::template particles<Point>(cells, outer_ppc))
                if (!inner(p)) points.push_back(p);
        }
        for (Point& p : points) {
            p.v[0] = velocity(p.X[0]);
            p.material = p.X[0] < length / 2 ? 0 : 1;
        }
        return points;
    }
    template <class Points> std::array<double, 2> watch(const Points& points, double t) const {
        return {this->v_cm(points), v_cm_exact(t)};
    }

    /// The same bar for total-Lagrangian schemes.
    ContrastBar<true> total_lagrangian() const {
        ContrastBar<true> bar;
        bar.E = E, bar.rho = rho, bar.length = length, bar.v0 = v0, bar.offset = this->offset, bar.contrast = contrast;
        bar.outer_ppc = outer_ppc;
        return bar;
    }

    using Observer = WaveObserver<ContrastBar>;

private:
    mutable double solved_for_ = 0, root_ = 0;  // contrast, a
};

}  // namespace mpm
