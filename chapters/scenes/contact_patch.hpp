/// A block under gravity and shear, whole or cut into two bodies (review 5.1): with a bonded interface both must move alike.
#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "lab/boundary.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"

namespace mpm {

/// A unit square that stands on a held foot, thrown sideways at the start. The cut is horizontal, at a height that need not lie on a grid
/// line. The reference, the whole block, is a run of its own.
struct ContactPatch {
    static constexpr int D = 2;
    static constexpr const char* name = "contact-patch";
    static constexpr const char* solves = "a block, whole or of two bodies, sways on a held foot";
    static constexpr const char* reference = "none";
    static constexpr std::array<const char*, 4> columns{"x_upper", "y_upper", "x_lower", "y_lower"};
    static constexpr bool may_break = true;
    using Law = NeoHookean;

    double E = 1000, nu = 0.3, rho = 1, g = 10, v0 = 1, cut = 0.53;
    bool whole = false;
    Dirichlet held = {};

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = -1, .high = 0.5, .low_open = true, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/area", above(0), "density");
        o.number("g", g, "length/time^2", at_least(0), "gravity");
        o.number("v0", v0, "length/time", at_least(0), "sideways velocity of the top at the start");
        o.number("cut", cut, "length", {.low = 0.1, .high = 0.9}, "height of the cut");
        o.flag("whole", whole, "one block, not cut: the reference");
    }
    void hold_foot(int cells) {
        for (const int axis : {0, 1}) held.hold_plane(lattice(cells, 1), 1, 0, true, axis);
    }

    Law law() const {
        const double G = E / (2 * (1 + nu));
        return {2 * G * nu / (1 - 2 * nu), G, rho};
    }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return v0; }
    Lattice<2> lattice(int cells, int per_cell) const {
        const double h = 1.0 / cells;
        const int pad = 2 + cells / 2;
        return {Vec<2>(-pad * h, -2 * h), Vec<2>::Constant(h), {cells + 2 * pad, cells + pad}, per_cell};
    }
    template <class Point> std::vector<std::vector<Point>> bodies(int cells, int ppc) const {
        std::vector<Point> all = particles_inside<Point>(Box{Vec<2>(0, 0), Vec<2>(1, 1)}, lattice(cells, 1), middles(ppc), rho);
        std::vector<Point> upper, lower;
        for (Point& p : all) p.v[0] = v0 * p.X[1];
        for (const Point& p : all) (p.X[1] > cut ? upper : lower).push_back(p);
        if (whole) return {all};
        if (upper.empty() || lower.empty()) throw BadInput("--cut: one of the bodies has no particle");
        return {lower, upper};
    }
    template <class Body> void load(Body& body, double) const {
        for (auto& node : body.grid) node.f[1] -= node.m * g;
    }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const { held.apply(grid, field); }
    template <class Bodies> Supply supply(const Bodies& all, double, double dt) const {
        Supply sum;
        for (const auto* body : all) {
            for (const auto& node : body->grid) sum.add(-dt * node.m * g, 1, 0.5 * (node.v[1] + node.v_new[1]));
            sum += held.supply(body->grid, dt);
        }
        return sum;
    }

    template <class Points> std::array<double, 4> watch(const Points& points, double) const {
        std::array<double, 4> x{};
        std::array<double, 2> m{};
        for (const auto& p : points) {
            const std::size_t side = p.X[1] > cut ? 0 : 1;
            m[side] += p.m;
            for (const std::size_t d : {std::size_t{0}, std::size_t{1}}) x[2 * side + d] += p.m * (p.x - p.X)[static_cast<int>(d)];
        }
        return {x[0] / m[0], x[1] / m[0], x[2] / m[1], x[3] / m[1]};
    }
    struct Observer {
        const ContactPatch& scene;
        std::array<double, 4> end{};
        template <class Points> void sample(const Points& points, double t, double) { end = scene.watch(points, t); }
        bool wants_energy(double, double) const { return false; }
        std::vector<NamedError> errors(double) const { return {{"none", std::numeric_limits<double>::quiet_NaN()}}; }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"displacement of the upper part, x", end[0]}, {"y", end[1]}, {"of the lower part, x", end[2]}, {"y ", end[3]}};
        }
    };
};

}  // namespace mpm
