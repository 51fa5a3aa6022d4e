/// The generalized vortex (review 6.2.3): a ring whose circles turn and shear as manufactured (vortex_motion.hpp); its edges stay at rest
/// and free of traction.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "chapters/mms/body_force.hpp"
#include "chapters/mms/observer.hpp"
#include "chapters/mms/ring_cut.hpp"
#include "chapters/mms/vortex_motion.hpp"
#include "lab/boundary.hpp"
#include "lab/fill.hpp"
#include "lab/options.hpp"

namespace mpm {

/// What the command line says of the ring.
struct VortexCase : VortexMotion {
    std::string placing = "mid";  // of particles: in the middles of equal parts of a cell, or at Gauss points
    BodyForce force;
    std::string boundary = "held";  // nodes beyond the ring: at rest ("held", as printed), or "free"
    // Particles whose part of a cell an edge of the ring cuts: the "fraction" inside, at its middle; or the "whole", if their place is
    // inside.
    std::string cut = "fraction";
    std::string start = "half";  // impulse of the first step: "half", or "whole"

    void declare(Options& o) {
        o.number("inner", R_i, "length", above(0), "inner radius of the ring, R_i");
        o.number("outer", R_o, "length", above(0), "outer radius of the ring, R_o");
        o.number("G", G, "-", {.low = 0, .high = 3, .low_open = true}, "largest angle, of the middle circle");
        o.number("T0", T0, "time", above(0), "half a period: at rest, turned by G at T0/2, and back");
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/volume", above(0), "density");
        o.choice("force", force.at, {"particles", "nodes"}, "where the body force acts");
        o.choice("points", placing, {"mid", "gauss"}, "particles in the middles of equal parts of a cell, or at Gauss points");
        o.choice("boundary", boundary, {"held", "free"}, "nodes beyond the ring: held at rest, or free of traction");
        o.choice("cut", cut, {"fraction", "whole"}, 
                 "particles at the edges: the fraction inside, or the whole if their place is inside");
        o.choice("start", start, {"half", "whole"}, "impulse of the first step; half: the velocities after it belong to dt/2");
    }
    /// Throws BadInput for a ring without a hole or a width.
    void check() const {
        if (R_i >= R_o) throw BadInput("--inner = " + std::to_string(R_i) + ": allowed < --outer = " + std::to_string(R_o));
    }
};

template <bool TotalLagrangian> struct Vortex : VortexCase {
    static constexpr int D = 2;
    static constexpr const char* name = "vortex";
    static constexpr const char* solves = "generalized vortex: a ring turned and sheared as manufactured, plane strain";
    static constexpr const char* reference = "manufactured";
    static constexpr std::array<const char*, 2> columns{"angle", "angle_exact"};
    using Law = NeoHookean;
    using Observer = DisplacementObserver<Vortex, TotalLagrangian>;

    explicit Vortex(const VortexCase& options) : VortexCase(options) {}

    /// |v| = g' h R at its largest, to second order in the width.
    double speed() const { return omega() * G * (middle() + width() * width() / (32 * middle())); }
    /// Of the sheared solid, whose waves outrun the P-wave: a plane wave along n in the deformed body moves with rho c^2 = mu n.FF^T n +
    /// lambda + mu, in the initial one, where total-Lagrangian grids are, along N with rho c^2 = mu + (lambda + mu) N.F^-1 F^-T N.
    double wave_speed() const {
        const double shear = largest_shear(), stretch2 = 1 + shear * (shear + std::hypot(shear, 2)) / 2;
        const double one = mu(), other = lambda() + mu();
        return std::sqrt((TotalLagrangian ? one + other * stretch2 : one * stretch2 + other) / rho);
    }
    Law law() const { return {lambda(), mu(), rho}; }

    /// `cells` across the ring, and `pad` more around it: nothing is folded at the ends of the grid.
    Lattice<2> lattice(int cells, int per_cell) const {
        const double h = 2 * R_o / cells;
        return {Vec<2>::Constant(-R_o - pad * h), Vec<2>::Constant(h), {cells + 2 * pad, cells + 2 * pad}, per_cell};
    }
    static constexpr int pad = 2;

    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        std::vector<Point> all;
        each_point({}, lattice(cells, 1), cell_rule(placing, ppc), [&](const Vec<2>& X, const Bounds& box) {
            const CutBox left = cut == "whole" ? CutBox{inside(X) ? 1.0 : 0.0, X} : cut_by_ring(box, R_i, R_o);
            if (left.part == 0) return;
            Point& p = all.emplace_back();
            p.X = p.x = left.part < 1 ? left.middle : X;
            p.V = p.V0 = left.part * (box.high - box.low).prod();
            p.m = rho * p.V;
            p.v = v(p.X, 0);
        });
        return all;
    }

    /// Half an impulse starts the leapfrog: velocities given for t = 0 become those of dt/2, while the ring is still free of stress.
    double part(double t) const { return t == 0 && start == "half" ? 0.5 : 1; }
    template <class Body> void load(Body& body, double t) const { force.load<TotalLagrangian>(body, *this, t, part(t)); }
    template <class Bodies> Supply supply(const Bodies& bodies, double t, double dt) const {
        return force.supply<TotalLagrangian>(bodies, *this, t, dt, part(t));
    }

    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        on_held(grid.lattice(), [&](int I) { (grid[I].*field).setZero(); });
    }
    template <class Grid> Vec<2> held_force(const Grid& grid) const {
        Vec<2> sum = Vec<2>::Zero();
        on_held(grid.lattice(), [&](int I) { sum += grid[I].f; });
        return sum;
    }

    /// The angle of the middle circle, fitted to all particles: the g for which g h(R) is nearest to how far they have turned; and g(t).
    template <class Points> std::array<double, 2> watch(const Points& points, double t) const {
        double turned = 0, weight = 0;
        for (const auto& p : points) {
            const double part_of_g = h(p.X.norm());
            turned += p.m * part_of_g * std::atan2(p.X[0] * p.x[1] - p.X[1] * p.x[0], p.X.dot(p.x));
            weight += p.m * part_of_g * part_of_g;
        }
        return {turned / weight, g(t)};
    }

private:
    bool inside(const Vec<2>& X) const {
        const double R = X.norm();
        return R >= R_i && R <= R_o;
    }
    /// Visits the held nodes: those beyond the ring, where the exact solution is at rest.
    template <class Visit> void on_held(const Lattice<2>& lattice, Visit&& visit) const {
        if (boundary == "free") return;
        for (int I = 0; I < lattice.size(); ++I)
            if (!inside(lattice.position(I))) visit(I);
    }
};

}  // namespace mpm
