/// A steel disk strikes an aluminium target at 1160 m/s (review 6.1.3, figures 63 and 64; Sulsky, Zhou and Schreyer 1995), in plane strain.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/materials.hpp"
#include "chapters/material/von_mises.hpp"
#include "lab/figure.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"

namespace mpm {

/// An isotropic elastic solid as the command line says it.
struct ElasticSettings {
    double E, nu, rho;  // modulus, ratio, density

    void declare(Options& o, const std::string& which) {
        o.number("E-" + which, E, "stress", above(0), "Young's modulus of the " + which);
        o.number("nu-" + which, nu, "-", {.low = -1, .high = 0.5, .low_open = true, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho-" + which, rho, "mass/volume", above(0), "density");
    }
    VonMises law() const { return {E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu)), rho}; }
};

/// What the command line says of the impact, in SI units. Moduli and the target's size are those of Sulsky, Zhou and Schreyer (1995).
struct ImpactSettings {
    ElasticSettings steel{200e9, 0.3, 7850}, target{78.2e9, 0.3, 2700};
    double yield = 300e6, hardening = 0;                                     // of the target
    double diameter = 9.53e-3, v0 = 1160, width = 60e-3, height = 40e-3;     // disk, its speed, target
    std::string walls = "slip";

    void declare(Options& o) {
        steel.declare(o, "disk");
        target.declare(o, "target");
        o.number("yield", yield, "stress", above(0), "yield stress of the target in uniaxial tension; the disk stays elastic");
        o.number("hardening", hardening, "stress", at_least(0), "d(yield stress)/d(equivalent plastic strain) of the target");
        o.number("diameter", diameter, "length", above(0), "of the disk");
        o.number("v0", v0, "length/time", above(0), "speed of the disk, downwards");
        o.number("width", width, "length", above(0), "of the target, from wall to wall; --cells go across it");
        o.number("height", height, "length", above(0), "of the target: rows of particles whose middles lie below it");
        o.choice("walls", walls, {"slip", "stuck"}, "bottom and sides of the box: held along their normals only, or wholly");
    }
};

/// Disk and target are one body of two materials: nodes that they share make the contact, without slip and without gap.
///
/// Both lie on the regular places of the grid's particles. The target has the rows whose middles lie below `height`. The disk's centre
/// stands above the topmost row by its radius, rounded up to whole particles; so its rows go on where the target's end. On 50 cells with
/// 2 x 2 particles, 0.6 mm apart: 67 rows of 100 = 6700, top at 40.2 mm, and 208 particles around (30, 45) mm: the review's 6908. Those
/// particles weigh 5 % more than the disk, and so on 25 cells; on 100 cells they weigh 0.6 % less, on 200 0.2 % more.
///
/// The depth converges slowly, 14.4, 20.2, 21.9, 23.7 mm on 25 to 200 cells (hat, MUSL). Perfect plasticity has no length of its own: the
/// largest plastic strain, in the wall of the crater, grows with every refinement (3, 7, 12, 19).
struct SteelDisk : ImpactSettings {
    static constexpr int D = 2;
    static constexpr const char* name = "steel-disk";
    static constexpr const char* solves = "a steel disk penetrates an aluminium target at high velocity";
    static constexpr const char* reference = "none";
    static constexpr std::array<const char*, 4> columns{"depth", "v_disk", "dissipated", "eps_p_max"};
    static constexpr bool may_break = true;  // target thrown out of the crater parts: metal would tear, and the law has no fracture
    using Law = Materials<VonMises>;
    enum Material { disk, block };

    double t_end = 40e-6;  // [time], for the room that flying particles need

    Law law() const {
        VonMises aluminium = target.law();
        aluminium.yield = yield;
        aluminium.H = hardening;
        return {{steel.law(), aluminium}};
    }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return v0; }
    Animated animated() const { return {"x", "y", "eps_p", "x [m]", "y [m]", "equivalent plastic strain"}; }

    double spacing(int cells, int ppc) const { return width / cells / ppc; }
    int rows(int cells, int ppc) const { return static_cast<int>(std::floor(height / spacing(cells, ppc) + 0.5)); }
    /// Height of the disk's centre above the target, in particles.
    int above_target(int cells, int ppc) const { return static_cast<int>(std::ceil(0.5 * diameter / spacing(cells, ppc))); }

    /// The box, `outside` cells beyond its walls for the reach of smooth functions, and room above for what flies up as fast as v0.
    Lattice<2> lattice(int cells, int per_cell) const {
        const double h = width / cells, tall = std::ceil((height + 1.5 * diameter + v0 * t_end) / h);
        if (!(tall < 1e5))
            throw BadInput("--height, --diameter, --v0, --t-end: " + number_text(tall) + " cells to the top, at most 1e5 are allowed");
        return {Vec<2>::Constant(-outside * h), Vec<2>::Constant(h), {cells + 2 * outside, static_cast<int>(tall) + 2 * outside}, per_cell};
    }

    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        if (!(diameter < width))
            throw BadInput("--diameter " + number_text(diameter) + ": less than --width " + number_text(width) + " is allowed");
        const double s = spacing(cells, ppc);
        const int n = cells * ppc, top = rows(cells, ppc), up = above_target(cells, ppc);
        const Vec<2> centre(0.5 * n, top + up);  // in particles
        std::vector<Point> all;
        const Law l = law();
        const auto add = [&](int i, int j, Material material) -> Point& {
            Point& p = all.emplace_back();
            p.X = p.x = Vec<2>((i + 0.5) * s, (j + 0.5) * s);
            p.V0 = p.V = s * s;
            p.m = l.of[material].rho * p.V0;
            p.material = material;
            return p;
        };
        for (int j = top; j < top + 2 * up; ++j)
            for (int i = 0; i < n; ++i)
                if ((Vec<2>(i + 0.5, j + 0.5) - centre).norm() * s <= 0.5 * diameter) add(i, j, disk).v = Vec<2>(0, -v0);
        if (all.empty()) throw BadInput("--cells, --ppc, --diameter: no particle lies inside the disk");
        for (int j = 0; j < top; ++j)
            for (int i = 0; i < n; ++i) add(i, j, block);
        return all;
    }

    template <class Body> void load(Body&, double) const {}
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        at_walls(grid.lattice(), [&](int I, int axis) { (grid[I].*field)[axis] = 0; });
    }
    template <class Grid> Vec<2> held_force(const Grid& grid) const {
        Vec<2> f = Vec<2>::Zero();
        at_walls(grid.lattice(), [&](int I, int axis) { f[axis] += grid[I].f[axis]; });
        return f;
    }

    /// `depth`: of the lowest steel below the target's first surface, the lower edge of the lowest disk particle, whose size is taken as
    /// at the start. `v_disk`: mean velocity of the disk, upwards.
    template <class Points> std::array<double, 4> watch(const Points& points, double) const {
        double lowest = std::numeric_limits<double>::infinity(), steel_mass = 0, momentum = 0, plastic_work = 0, eps_p = 0;
        double surface = 0;
        for (const auto& p : points) {
            plastic_work += p.plastic_work;
            eps_p = std::max(eps_p, p.eps_p);
            const double half = 0.5 * std::sqrt(p.V0);
            if (p.material == block) {
                surface = std::max(surface, p.X[1] + half);
                continue;
            }
            lowest = std::min(lowest, p.x[1] - half);
            steel_mass += p.m;
            momentum += p.m * p.v[1];
        }
        return {surface - lowest, momentum / steel_mass, plastic_work, eps_p};
    }

    /// There is nothing exact to compare with: the error is nan, and the facts are what one looks at.
    struct Observer {
        const SteelDisk& scene;
        double start = 0;                // energy
        std::array<double, 4> last{};    // what was watched at the end
        double end = 0, area = 0;        // energy at the end; area of the disk's particles

        template <class Points> void sample(const Points& points, double t, double energy) {
            if (t == 0) {
                start = energy;
                for (const auto& p : points)
                    if (p.material == disk) area += p.V0;
            }
            if (std::isnan(energy)) return;
            end = energy;
            last = scene.watch(points, t);
        }
        bool wants_energy(double t, double t_end) const { return t == 0 || t >= t_end; }
        std::vector<NamedError> errors(double) const { return {{"depth", std::numeric_limits<double>::quiet_NaN()}}; }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"area of the disk's particles / its own", area / (std::numbers::pi / 4 * scene.diameter * scene.diameter)},
                    {"depth at the end", last[0]},
                    {"velocity of the disk, upwards", last[1]},
                    {"plastic work / energy at the start", last[2] / start},
                    {"energy left, kinetic and elastic", end / start},
                    {"largest equivalent plastic strain", last[3]}};
        }
    };

private:
    static constexpr int outside = 3;  // cells beyond each wall

    /// Visits each held component of a node on or beyond a wall once.
    template <class Visit> void at_walls(const Lattice<2>& lattice, Visit&& visit) const {
        const int nx = lattice.nodes(0), ny = lattice.nodes(1);
        const bool stuck = walls == "stuck";
        for (int j = 0; j < ny; ++j) {
            const bool bottom = j <= outside;
            for (int i = 0; i < nx; ++i) {
                const bool side = i <= outside || i >= nx - 1 - outside;
                if (side || (stuck && bottom)) visit(j * nx + i, 0);
                if (bottom || (stuck && side)) visit(j * nx + i, 1);
                if (i == outside && !bottom) i = nx - 2 - outside;  // to the other side
            }
        }
    }
};

}  // namespace mpm
