/// A small particle falls on a wide one (review 3.7, figures 31 and 32): CPDI sees the grid at corners alone, and between the corners of a
/// domain longer than three cells another particle slips through.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "lab/boundary.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/tessellated.hpp"

namespace mpm {

/// A square of 7 x 7 with two rectangular particles of one velocity field, no other forces. Particle 0 is the small one, all others the
/// wide one.
struct Hole : FreeScene, Tessellated {
    static constexpr int D = 2;
    static constexpr const char* name = "hole";
    static constexpr const char* solves = "a small particle falls on a wide one at rest";
    static constexpr const char* reference = "none";
    static constexpr std::array<const char*, 4> columns{"y_small", "v_small", "y_wide", "v_wide"};
    static constexpr bool may_break = true, numbered = true;
    static constexpr double side = 7;
    using Law = NeoHookean;

    double E = 100, nu = 0, rho = 1, wide = 3.4, small = 0.8, v0 = 1;  // modulus, ratio, density, widths, speed

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/area", above(0), "density");
        o.number("wide", wide, "length", {.low = 0, .high = 6, .low_open = true}, "width of the wide particle; the square has side 7");
        o.number("small", small, "length", {.low = 0, .high = 1, .low_open = true}, "width of the small particle; both are as high");
        o.number("v0", v0, "length/time", above(0), "speed of the small particle, downward");
    }
    Law law() const {
        const double mu = E / (2 * (1 + nu));
        return {2 * mu * nu / (1 - 2 * nu), mu, rho};
    }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return v0; }
    Lattice<2> lattice(int cells, int per_cell) const { return {Vec<2>(0, 0), Vec<2>::Constant(side / cells), {cells, cells}, per_cell}; }

    std::vector<PolygonCells> tessellate(const std::string&, int, int) const {
        PolygonCells mesh;
        const auto rectangle = [&](const Vec<2>& centre, double width) {
            const Vec<2> r(width / 2, small / 2);
            const int c = static_cast<int>(mesh.points.size());
            for (const Vec<2>& sign : {Vec<2>(-1, -1), Vec<2>(1, -1), Vec<2>(1, 1), Vec<2>(-1, 1)})
                mesh.points.push_back(centre + sign.cwiseProduct(r));
            mesh.corners.push_back({c, c + 1, c + 2, c + 3});
        };
        rectangle({side / 2, 5.5}, small);
        rectangle({side / 2, 3.5}, wide);
        return {mesh};
    }
    template <class Point> std::vector<std::vector<Point>> bodies(int, int) const {
        auto all = bodies_of<Point>(rho, [](Point&) {});
        all[0][0].v[1] = -v0;
        return all;
    }

    /// Height and velocity of the small particle, and of the wide one's centre of mass.
    template <class Points> std::array<double, 4> watch(const Points& points, double) const {
        double m = 0, my = 0, mv = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const auto& p = points[i];
            m += p.m, my += p.m * p.x[1], mv += p.m * p.v[1];
        }
        return {points[0].x[1], points[0].v[1], my / m, mv / m};
    }

    struct Observer {
        const Hole& scene;
        std::array<double, 4> end{};
        std::size_t particles = 0;

        template <class Points> void sample(const Points& points, double t, double) {
            end = scene.watch(points, t);
            particles = points.size();
        }
        bool wants_energy(double, double) const { return false; }
        std::vector<NamedError> errors(double) const { return {{"felt", std::numeric_limits<double>::quiet_NaN()}}; }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"height of the small particle at the end", end[0]},
                    {"height of the wide one", end[2]},
                    {"part of its momentum that the small one gave", 1 + end[1] / scene.v0},
                    {"particles at the end", static_cast<double>(particles)}};
        }
    };
};

}  // namespace mpm
