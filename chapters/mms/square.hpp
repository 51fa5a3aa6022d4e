/// The axis-aligned unit square (review 6.2.2 in plane strain): stretched along both axes as manufactured, in turn.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "chapters/mms/body_force.hpp"
#include "chapters/mms/motion.hpp"
#include "chapters/mms/observer.hpp"
#include "lab/boundary.hpp"
#include "lab/fill.hpp"
#include "lab/options.hpp"

namespace mpm {

/// u_i = G sin(pi X_i) sin(c pi t + phi_i) with phi = (0, pi) and c = sqrt(E/rho) (6.8), of a neo-Hookean solid with F33 = 1. Along each
/// axis that is the segment's motion, along the second one with -G; the axes meet in ln det F alone.
struct SquareMotion {
    double G = 1e-4, E = 1e7, nu = 0.3, rho = 1000;  // amplitude [length], Young's modulus [stress], Poisson's ratio [-], initial density

    SegmentMotion along(int axis) const { return {axis == 0 ? G : -G, E, nu, rho, 1}; }
    double lambda() const { return along(0).lambda(); }
    double mu() const { return along(0).mu(); }
    double k_pi() const { return along(0).k_pi(); }
    double omega() const { return along(0).omega(); }
    double period() const { return along(0).period(); }

    Vec<2> u(const Vec<2>& X, double t) const { return {along(0).u(X[0], t), along(1).u(X[1], t)}; }
    Vec<2> v(const Vec<2>& X, double t) const { return {along(0).v(X[0], t), along(1).v(X[1], t)}; }
    Mat<2> F(const Vec<2>& X, double t) const { return Vec<2>(along(0).F(X[0], t), along(1).F(X[1], t)).asDiagonal(); }
    Vec<2> x(const Vec<2>& X, double t) const { return X + u(X, t); }
    Vec<2> X_of(const Vec<2>& place, double t) const { return {along(0).X_of(place[0], t), along(1).X_of(place[1], t)}; }

    /// Body force per mass (6.9), there with F33.
    Vec<2> b(const Vec<2>& X, double t) const {
        const double wave = std::sin(omega() * t), pi2_per_rho = k_pi() * k_pi() / rho;
        Vec<2> u_now, F_now;
        for (int d = 0; d < 2; ++d) {
            const double amplitude = (d == 0 ? G : -G) * wave;
            u_now[d] = amplitude * std::sin(k_pi() * X[d]);
            F_now[d] = 1 + amplitude * k_pi() * std::cos(k_pi() * X[d]);
        }
        const double lnJ = std::log(F_now[0] * F_now[1]);
        Vec<2> force;
        for (int d = 0; d < 2; ++d) {
            const double per_F2 = 1 / (F_now[d] * F_now[d]);
            force[d] = pi2_per_rho * u_now[d] * (lambda() * per_F2 * (1 - lnJ) + mu() * (1 + per_F2) - E);
        }
        return force;
    }
};

/// What the command line says of the square.
struct SquareCase : SquareMotion {
    std::string placing = "mid";  // of particles: in the middles of equal parts of a cell, or at Gauss points
    BodyForce force;

    void declare(Options& o) {
        o.number("G", G, "length", above(0), "largest displacement; the square's sides are 1");
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/volume", above(0), "density");
        o.choice("force", force.at, {"particles", "nodes"}, "where the body force acts");
        o.choice("points", placing, {"mid", "gauss"}, "particles in the middles of equal parts of a cell, or at Gauss points");
    }
    /// Throws BadInput for a motion that would turn the square inside out.
    void check() const {
        if (k_pi() * G >= 1) throw BadInput("--G = " + std::to_string(G) + ": allowed < " + std::to_string(1 / k_pi()));
    }
};

/// The square is as large as the grid, whose faces hold the velocity normal to them; along a face the material slips (not at rest, as 6.10
/// reads). The force vanishes with the displacement at t = 0: velocities half a step before or after differ by O(dt^2) only.
template <bool TotalLagrangian> struct Square : SquareCase {
    static constexpr int D = 2;
    static constexpr const char* name = "square";
    static constexpr const char* solves = "manufactured vibration of a unit square between slippery walls, plane strain";
    static constexpr const char* reference = "manufactured";
    static constexpr std::array<const char*, 4> columns{"v_cm_x", "v_cm_x_exact", "v_cm_y", "v_cm_y_exact"};
    using Law = NeoHookean;
    using Observer = DisplacementObserver<Square, TotalLagrangian>;

    explicit Square(const SquareCase& options) : SquareCase(options) {}

    double speed() const { return std::sqrt(2.0) * omega() * G; }
    double wave_speed() const { return law().wave_speed(); }
    Law law() const { return {lambda(), mu(), rho}; }
    Lattice<2> lattice(int cells, int per_cell) const {
        return {Vec<2>::Zero(), Vec<2>::Constant(1.0 / cells), {cells, cells}, per_cell};
    }

    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        std::vector<Point> all;
        each_point({Vec<2>::Zero(), Vec<2>::Ones()}, lattice(cells, 1), cell_rule(placing, ppc), [&](const Vec<2>& X, const Bounds& box) {
            Point& p = all.emplace_back();
            p.X = p.x = X;
            p.V = p.V0 = (box.high - box.low).prod();
            p.m = rho * p.V;
            p.v = v(X, 0);
        });
        return all;
    }

    template <class Body> void load(Body& body, double t) const { force.load<TotalLagrangian>(body, *this, t); }
    template <class Bodies> Supply supply(const Bodies& bodies, double t, double dt) const {
        return force.supply<TotalLagrangian>(bodies, *this, t, dt);
    }

    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        on_faces(grid.lattice(), [&](int I, int normal) { (grid[I].*field)[normal] = 0; });
    }
    template <class Grid> Vec<2> held_force(const Grid& grid) const {
        Vec<2> sum = Vec<2>::Zero();
        on_faces(grid.lattice(), [&](int I, int normal) { sum[normal] += grid[I].f[normal]; });
        return sum;
    }

    /// Velocity of the centre of mass and what it should be: along an axis that of the segment, (2/pi) omega G cos(omega t).
    template <class Points> std::array<double, 4> watch(const Points& points, double t) const {
        double m = 0;
        Vec<2> mv = Vec<2>::Zero();
        for (const auto& p : points) m += p.m, mv += p.m * p.v;
        const double exact = 2 * omega() * G / k_pi() * std::cos(omega() * t);
        return {mv[0] / m, exact, mv[1] / m, -exact};
    }

private:
    /// Visits the nodes of the four faces with the axis normal to the face; a corner node twice.
    template <class Visit> static void on_faces(const Lattice<2>& lattice, Visit&& visit) {
        for (const int normal : {0, 1}) {
            const int across = lattice.stride(normal) * (lattice.nodes(normal) - 1), along = 1 - normal;
            for (int i = 0; i < lattice.nodes(along); ++i)
                for (const int I : {i * lattice.stride(along), i * lattice.stride(along) + across}) visit(I, normal);
        }
    }
};

}  // namespace mpm
