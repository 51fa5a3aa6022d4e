/// A ring between a fixed rigid floor and a rigid platen that comes down (review 4.2.4, figure 40).
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

#include "chapters/material/linear_elastic.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "chapters/material/one_of.hpp"
#include "chapters/scenes/elastica_ring.hpp"
#include "lab/fill.hpp"
#include "lab/monitor.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"
#include "lab/rigid_body.hpp"

namespace mpm {

/// What the command line says of the ring and of the platen.
struct RingSettings {
    double E = 1000, nu = 0.3, rho = 1000, radius = 0.5, thickness = 0.1;  // modulus, ratio, density, outer radius, wall
    double v0 = 0.01, rise = 30;                                          // platen: velocity, time to reach it
    double gap = 1;                                                       // between the ring and held nodes at the start [cells]
    double damping = 0.02;                                                // [1/time]
    std::string law = "neo-hookean", plates = "stick";

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = -1, .high = 0.5, .low_open = true, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/area", above(0), "density");
        o.number("radius", radius, "length", above(0), "outer radius of the ring");
        o.number("thickness", thickness, "length", above(0), "thickness of its wall");
        o.number("v0", v0, "length/time", above(0), "velocity of the platen, downwards");
        o.number("rise", rise, "time", at_least(0), "time in which the platen smoothly reaches its velocity");
        o.number("gap", gap, "cells", between(0, 4), "between the ring and the held nodes of platen and floor at the start");
        o.number("damping", damping, "1/time", at_least(0), "viscous damping: a force -damping m v on every node");
        o.choice("law", law, {"neo-hookean", "linear"}, "neo-Hookean, or linear elastic in rate form");
        o.choice("plates", plates, {"stick", "slip"}, "whether platen and floor hold both components of the velocity or the normal one");
    }

    Ramp<2> motion() const { return {Vec<2>(0, -v0), rise}; }
    /// When the platen has come down by `part` of the diameter.
    double time_of(double part) const {
        const double way = part * 2 * radius;
        double low = 0, high = rise + way / v0;  // the displacement grows with time
        for (int i = 0; i < 200 && high - low > 0; ++i) {
            const double t = 0.5 * (low + high);
            (-motion().displacement(t)[1] < way ? low : high) = t;
        }
        return high;
    }

    /// Displacement over force (per unit depth) of a ring pressed by two opposite forces, plane strain: curved beam of Winkler and Bach
    /// with the energies of bending, normal and shear force (Roark's Formulas for Stress and Strain, circular rings, load case 1). A thin
    /// ring gives 0.149 R^3/(E' I).
    double beam_compliance() const {
        const double R = radius - thickness / 2, E_strain = E / (1 - nu * nu), G = E / (2 * (1 + nu));
        const double e = R - thickness / std::log(radius / (radius - thickness));  // from the centroid to the neutral axis
        const double hoop = e / R, shear = 1.2 * E_strain / G * e / R;             // 1.2: shear factor of a rectangle
        const double k1 = 1 - hoop + shear, k2 = 1 - hoop;
        return R * R / (E_strain * thickness * e) * (std::numbers::pi / 4 * k1 - 2 / std::numbers::pi * k2 * k2);
    }
    double thin_compliance() const {
        const double R = radius - thickness / 2, t = thickness;
        return (std::numbers::pi / 4 - 2 / std::numbers::pi) * R * R * R * 12 * (1 - nu * nu) / (E * t * t * t);
    }
};

/// For updated-Lagrangian schemes: the held nodes of the one grid are the contact, up to a cell early, which the gap makes up for. The ring
/// is not pulled at by weight, its lowest point is the origin.
struct SmashedRing : RingSettings {
    static constexpr int D = 2;
    static constexpr const char* name = "smashed-ring";
    static constexpr const char* solves = "a ring on a rigid floor, crushed by a rigid platen";
    static constexpr const char* reference = "elastica";
    static constexpr std::array<const char*, 7> columns{"displacement", "force_platen", "force_floor", "force_elastica",
                                                         "force_beam",   "height",       "width"};
    static constexpr bool may_break = true;  // the hole of the ring closes
    using Law = OneOf<NeoHookean, LinearElastic>;

    RigidBody<2> platen{}, floor{};
    ElasticaRing thin{};
    double h = 1;  // [length]
    double now = 0;                                   // after the last step [time]
    double force_platen = 0, force_floor = 0;         // on the ring in the last step, positive in compression [force/length of depth]
    double impulse_platen = 0, impulse_floor = 0, last_row = 0;  // since the last row of the history, and its time

    SmashedRing() = default;
    /// `support`: nodes that the weighting function touches along an axis. Throws BadInput.
    SmashedRing(const RingSettings& settings, int cells, int support) : RingSettings(settings) {
        if (!(thickness < radius))
            throw BadInput("--thickness = " + number_text(thickness) + ": allowed below --radius = " + number_text(radius));
        h = 2 * radius / cells;
        platen.reach = floor.reach = RigidBody<2>::reach_of(support);
        platen.motion = motion();
        if (plates == "slip") platen.normal = floor.normal = 1;
        // The platen's lowest particles lie on a grid line and enter the next row of elements when it starts, the floor's never do.
        const double off = (gap + platen.reach) * h;
        for (int row = 0; row < 2 * plate_cells(cells); ++row)
            for (int column = 0; column < 2 * half_plate_cells(cells); ++column)
                for (const double side : {-1.0, 1.0}) {
                    const double x = side * (column + 0.5) * h / 2;
                    platen.X.emplace_back(x, 2 * radius + off + row * h / 2);
                    floor.X.emplace_back(x, -off - (row + 0.5) * h / 2);
                }
    }

    Law law() const { return {RingSettings::law, E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu)), rho}; }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return v0; }

    static int plate_cells(int cells) { return std::max(2, (cells + 9) / 10); }         // thickness of platen and floor
    static int half_plate_cells(int cells) { return (13 * cells + 19) / 20; }           // half their width
    /// Room for the flattened ring, whose outer half circumference is pi radius, and for platen and floor.
    Lattice<2> lattice(int cells, int per_cell) const {
        const int half = (8 * cells + 9) / 10 + 3, room = static_cast<int>(std::ceil(gap)) + platen.reach + plate_cells(cells) + 2;
        return {Vec<2>(-half * h, -room * h), Vec<2>(h, h), {2 * half, cells + 2 * room}, per_cell};
    }

    /// Whether a place lies in the ring.
    bool inside(const Vec<2>& X) const {
        const double r = (X - Vec<2>(0, radius)).norm();
        return r <= radius && r >= radius - thickness;
    }
    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        const CellRule rule = middles(ppc);
        std::vector<Point> ring;
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i)
                for (const double b : rule.at)
                    for (const double a : rule.at) {
                        const Vec<2> X((i + a) * h - radius, (j + b) * h);
                        if (!inside(X)) continue;
                        Point& p = ring.emplace_back();
                        p.X = p.x = X;
                        p.V0 = p.V = h * h / (ppc * ppc);
                        p.m = rho * p.V0;
                    }
        if (ring.empty()) throw BadInput("--cells, --ppc, --thickness: no particle lies inside the ring");
        return ring;
    }

    template <class Body> void load(Body& body, double) const {
        if (damping == 0) return;
        for (auto& node : body.grid) node.f -= damping * node.mv;
    }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double t) const {
        floor.apply(grid, field, t);
        platen.apply(grid, field, t);
    }

    /// After a step: what platen, floor and damping gave. Internal forces sum to zero, so that the sum of the nodal forces is the damping.
    template <class Bodies> Supply supply(const Bodies& bodies, double t, double dt) {
        const auto& grid = bodies[0]->grid;
        Supply sum = platen.supply(grid, t + dt, dt);
        const Supply from_floor = floor.supply(grid, t + dt, dt);
        force_platen = -sum.impulse[1] / dt;
        force_floor = from_floor.impulse[1] / dt;
        impulse_platen += dt * force_platen;
        impulse_floor += dt * force_floor;
        now = t + dt;
        sum += from_floor;
        if (damping > 0)
            for (const auto& node : grid) {
                for (int d = 0; d < D; ++d) sum.impulse[static_cast<std::size_t>(d)] += dt * node.f[d];
                sum.work -= dt * damping * node.m * node.v.squaredNorm();
            }
        return sum;
    }
    /// Platen and floor, for snapshots.
    std::vector<std::vector<RigidPoint<2>>> rigid() const {
        std::vector<std::vector<RigidPoint<2>>> all(2);
        for (std::size_t i = 0; i < platen.X.size(); ++i) {
            all[0].push_back(platen.particle(i, now));
            all[1].push_back(floor.particle(i, now));
        }
        return all;
    }

    double displacement(double t) const { return -platen.motion.displacement(t)[1]; }
    /// The force of a thin ring at any displacement, made softer by what normal and shear force add for a thick one at small displacements.
    double elastica(double displacement) const {
        const double R = radius - thickness / 2, unit = (std::numbers::pi / 4 - 2 / std::numbers::pi) * R / beam_compliance();
        return unit * thin.force(displacement / R);
    }

    /// Forces are means since the last row: each row is to be asked for once. The beam's force is that of small displacements.
    template <class Points> std::array<double, 7> watch(const Points& points, double t) {
        Vec<2> low = Vec<2>::Constant(std::numeric_limits<double>::infinity()), high = -low;
        for (const auto& p : points) low = low.cwiseMin(p.x), high = high.cwiseMax(p.x);
        const double span = t - last_row;
        const double mean_platen = span > 0 ? impulse_platen / span : 0, mean_floor = span > 0 ? impulse_floor / span : 0;
        impulse_platen = impulse_floor = 0;
        last_row = t;
        const double u = displacement(t);
        return {u, mean_platen, mean_floor, elastica(u), u / beam_compliance(), high[1] - low[1], high[0] - low[0]};
    }

    /// Slope of a force between its means over two stretches of the platen's way.
    struct Secant {
        std::array<double, 2> force{}, place{}, way{};  // integrals over each stretch
        void add(std::size_t stretch, double f, double u, double du) {
            force[stretch] += f * du;
            way[stretch] += du;
            place[stretch] += u * du;
        }
        double slope() const { return (force[1] / way[1] - force[0] / way[0]) / (place[1] / way[1] - place[0] / way[0]); }
    };

    /// Compares slopes of force against displacement: forces themselves are shifted by where in a cell the contact began. They have waves, since
    /// platen and ring cross grid lines, of the length of a cell: the slope is that between the means over the first and the last cell of
    /// `window`, in parts of the diameter. The mean of platen and floor leaves out what accelerates the ring.
    struct Observer {
        const SmashedRing& scene;
        static constexpr std::array<double, 2> window{0.02, 0.16};
        Secant platen{}, floor{}, exact{};
        double u = 0;  // displacement

        template <class Points> void sample(const Points&, double t, double) {
            const double now = scene.displacement(t), du = now - u, diameter = 2 * scene.radius;
            u = now;
            const double from = u - window[0] * diameter, to = window[1] * diameter - u;
            if (from < 0 || to < 0) return;
            for (const std::size_t stretch : {0u, 1u}) {
                if ((stretch == 0 ? from : to) > scene.h) continue;
                platen.add(stretch, scene.force_platen, u, du);
                floor.add(stretch, scene.force_floor, u, du);
                exact.add(stretch, scene.elastica(u), u, du);
            }
        }
        bool wants_energy(double, double) const { return false; }
        double stiffness() const { return (platen.slope() + floor.slope()) / 2; }
        std::vector<NamedError> errors(double) const { return {{"stiffness", std::abs(stiffness() / exact.slope() - 1)}}; }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"stiffness of a thin ring, E' I/(0.149 R^3)", 1 / scene.thin_compliance()},
                    {"of the curved beam", 1 / scene.beam_compliance()},
                    {"of the elastica, 2 to 16 % compressed", exact.slope()},
                    {"of this ring, the same", stiffness()},
                    {"this ring / elastica - 1", stiffness() / exact.slope() - 1},
                    {"stiffness at the platen / at the floor", platen.slope() / floor.slope()},
                    {"compression at the end / diameter", u / (2 * scene.radius)}};
        }
    };
};

}  // namespace mpm
