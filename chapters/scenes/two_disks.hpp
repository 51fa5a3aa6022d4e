/// Two elastic disks fly at each other along the diagonal of a unit square, meet and rebound (review 6.1.2, figures 60 to 62).
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
#include "lab/boundary.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"

namespace mpm {

/// What the command line says of the disks.
struct DiskSettings {
    double E = 1000, nu = 0.3, rho = 1000, radius = 0.2, v0 = 0.1;  // modulus, ratio, density, radius, each velocity component
    double offset = 0;                                              // shift of both disks against the grid, both axes [cells]
    std::string law = "linear";

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = -1, .high = 0.5, .low_open = true, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/area", above(0), "density");
        o.number("radius", radius, "length", {.low = 0.02, .high = 0.2}, "radius of both disks; their centres are at (.2, .2) and (.8, .8)");
        o.number("v0", v0, "length/time", above(0), "each component of the lower disk's velocity; the upper one's are opposite");
        o.number("offset", offset, "cells", between(-0.5, 0.5), "shift of both disks against the grid");
        o.choice("law", law, {"linear", "neo-hookean"}, "linear elastic in rate form, as printed, or neo-Hookean");
    }

    /// When the disks touch, centres coming closer with 2 sqrt(2) v0 (review 6.1.2; 1.5858 s as printed).
    double contact_time() const { return (0.6 * std::numbers::sqrt2 - 2 * radius) / (2 * std::numbers::sqrt2 * v0); }
};

/// Updated-Lagrangian schemes move both disks through one velocity field, whose nodes make the contact. Total-Lagrangian ones have a
/// field for each disk, on which nothing lets them feel each other: they pass through each other, and the run says so.
template <bool TotalLagrangian> struct TwoDisks : DiskSettings {
    static constexpr int D = 2;
    static constexpr const char* name = "two-disks";
    static constexpr const char* solves = "two elastic disks meet on the diagonal of a unit square and rebound";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 3> columns{"approach", "approach_exact", "asymmetry"};
    static constexpr bool may_break = true;  // there is a gap between the disks
    static constexpr bool numbered = true;   // particle i of one disk mirrors particle i of the other
    using Law = OneOf<LinearElastic, NeoHookean>;

    double t_end = 3.5;  // [time], for the room that the disks need

    Law law() const { return {DiskSettings::law, E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu)), rho}; }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return std::numbers::sqrt2 * v0; }

    /// The unit square with room on all sides: for the reach of smooth functions, and for disks that fly on after t_end of the review.
    Lattice<2> lattice(int cells, int per_cell) const {
        const double h = 1.0 / cells, flight = std::max(0.0, v0 * (t_end - 2 * contact_time()));
        const double room = std::ceil(TotalLagrangian ? 0 : flight * cells);
        if (!(room < 1e5)) throw BadInput("--t-end, --v0: the disks fly over " + number_text(room) + " cells, at most 1e5 are allowed");
        const int pad = 3 + static_cast<int>(room);
        return {Vec<2>::Constant(-pad * h), Vec<2>::Constant(h), {cells + 2 * pad, cells + 2 * pad}, per_cell};
    }

    /// The lower left disk: particles of the cells' regular places that lie inside.
    template <class Point> std::vector<Point> lower_disk(int cells, int ppc) const {
        const double h = 1.0 / cells;
        const Lattice<2> square(Vec<2>::Zero(), Vec<2>::Constant(h), {cells, cells});
        std::vector<Point> disk = particles_inside<Point>(Disk{Vec<2>(0.2, 0.2), radius}, square, middles(ppc), rho);
        for (Point& p : disk) {
            p.X = p.x += Vec<2>::Constant(offset * h);
            p.v = Vec<2>(v0, v0);
        }
        if (disk.empty()) throw BadInput("--cells, --ppc, --radius: no particle lies inside the disks");
        return disk;
    }
    template <class Point> std::vector<std::vector<Point>> bodies(int cells, int ppc) const {
        std::vector<Point> lower = lower_disk<Point>(cells, ppc), upper = lower;
        for (Point& p : upper) {
            p.X = p.x = Vec<2>::Constant(1 + 2 * offset / cells) - p.x;
            p.v = -p.v;
        }
        if constexpr (TotalLagrangian) return {lower, upper};
        lower.insert(lower.end(), upper.begin(), upper.end());
        return {lower};
    }

    template <class Body> void load(Body&, double) const {}
    template <class Grid, class Field> void fix(Grid&, Field, double) const {}

    /// Distance of the disks' centres and what it is until they touch; and how far the disks are from mirroring each other.
    template <class Points> std::array<double, 3> watch(const Points& points, double t) const {
        const std::size_t half = points.size() / 2;
        std::vector<Vec<2>> moved;
        Vec<2> apart = Vec<2>::Zero();
        double asymmetry = 0;
        for (const auto& p : points) {
            const Vec<2> u = p.x - p.X;
            apart += moved.size() < half ? -p.x : p.x;
            if (moved.size() >= half) asymmetry = std::max(asymmetry, (u + moved[moved.size() - half]).template lpNorm<Eigen::Infinity>());
            moved.push_back(u);
        }
        const double exact = 0.6 * std::numbers::sqrt2 - 2 * std::numbers::sqrt2 * v0 * t;
        return {apart.norm() / static_cast<double>(half), t < contact_time() ? exact : std::numeric_limits<double>::quiet_NaN(), asymmetry};
    }

    /// Contact is felt when the kinetic energy has fallen by a part of itself. The errors' names tell the part.
    struct Observer {
        const TwoDisks& scene;
        static constexpr std::array<double, 2> parts{0.001, 0.01};
        double first = 0, least = 0, t_least = 0, energy_end = 0;  // kinetic energy at the start, its minimum and when; energy at the end
        std::array<double, 2> contact = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

        template <class Points> void sample(const Points& points, double t, double energy) {
            double kinetic = 0;
            for (const auto& p : points) kinetic += 0.5 * p.m * p.v.squaredNorm();
            if (t == 0) first = least = kinetic;
            if (kinetic < least) least = kinetic, t_least = t;
            for (std::size_t i = 0; i < parts.size(); ++i)
                if (std::isnan(contact[i]) && kinetic < (1 - parts[i]) * first) contact[i] = t;
            if (!std::isnan(energy)) energy_end = energy;
        }
        bool wants_energy(double t, double t_end) const { return t >= t_end; }
        std::vector<NamedError> errors(double) const {
            const double exact = scene.contact_time();
            return {{"contact_0.1%", std::abs(contact[0] / exact - 1)},
                    {"contact_1%", std::abs(contact[1] / exact - 1)},
                    {"energy", std::abs(energy_end / first - 1)}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"kinetic energy at the start", first},
                    {"the same of whole disks", 2 * std::numbers::pi * scene.radius * scene.radius * scene.rho * scene.v0 * scene.v0},
                    {"least kinetic energy", least},
                    {"at t", t_least},
                    {"energy at the end / at the start - 1", energy_end / first - 1},
                    {"contact exact", scene.contact_time()},
                    {"contact, kinetic energy fallen 0.1 %", contact[0]},
                    {"contact, kinetic energy fallen 1 %", contact[1]}};
        }
    };
};

}  // namespace mpm
