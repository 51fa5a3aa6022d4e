/// Two elastic bodies, each one cell long, fly at each other and rebound (review 3.2, figures 13 and 14): what a particle feels when it
/// crosses into another cell.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/linear_elastic.hpp"
#include "lab/boundary.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"

namespace mpm {

/// What particles feel from one step to the next. The edges of cells are no part of the problem, so strain rates and forces should change
/// by O(dt) in a step, wherever a particle is; with hat functions both jump at an edge, however small the step.
class CrossingMeter {
public:
    double rate = 0;        // strain rate of the watched particle in the last step [1/time]
    double rate_jump = 0;   // largest change of a particle's strain rate from step to step [1/time]
    double force_jump = 0;  // largest change of a particle's acceleration from step to step [length/time^2]
    int crossings = 0;      // particle steps that ended in another cell

    template <class Points>
    void see(const Points& points, std::size_t watched, double t, double h) {
        past_.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double x = points[i].x[0], v = points[i].v[0], F = points[i].F(0, 0);
            Past& p = past_[i];
            if (t > 0) {
                const double L = (F / p.F - 1) / (t - t_), a = (v - p.v) / (t - t_);  // F was updated as (1 + L dt) F
                rate_jump = std::max(rate_jump, std::abs(L - p.L));
                force_jump = std::max(force_jump, std::abs(a - p.a));
                if (std::floor(x / h) != std::floor(p.x / h)) ++crossings;
                p.L = L, p.a = a;
            }
            p.x = x, p.v = v, p.F = F;
        }
        rate = past_[watched].L;
        t_ = t;
    }

private:
    struct Past {
        double x, v, F, L = 0, a = 0;
    };
    std::vector<Past> past_;
    double t_ = 0;
};

/// The bodies fill the first and the last cell of [0, L] and have velocities v0 and -v0. They meet when they first share a node, which the
/// weighting functions decide. Elastic bars of one length exchange their velocities and part without stress.
///
/// Why hat functions fail: a particle alone at a distance r h from a node strains itself through its own nodes with the frequency
/// c sqrt(sum grad^2/phi) = (c/h)/sqrt(r (1 - r)), which no time step follows as r goes to zero. Where the functions are smooth, grad^2/phi
/// is bounded.
struct TwoBodies {
    static constexpr int D = 1;
    static constexpr const char* name = "two-bodies";
    static constexpr const char* solves = "two elastic bodies, each one cell long, meet and rebound";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 4> columns{"x", "v", "stress", "strain_rate"};  // of the first body's inner particle
    static constexpr bool may_break = true;                                                  // there is a gap between the bodies
    using Law = LinearElastic;

    double E = 1000, rho = 1000, length = 1, v0 = 0.1;  // modulus, density, length between the outer ends, speed
    double offset = 0, t_end = 4;                       // shift of both bodies [cells], end of the run [time]
    int cells = 6;                                      // over `length`
    std::shared_ptr<CrossingMeter> meter = std::make_shared<CrossingMeter>();

    void declare(Options& o) {
        o.integer("cells", cells, "cells", between(4, 100000), "cells from one outer end to the other");
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("rho", rho, "mass/length", above(0), "density");
        o.number("length", length, "length", above(0), "distance of the bodies' outer ends");
        o.number("v0", v0, "length/time", above(0), "speed of each body");
        o.number("offset", offset, "cells", between(-0.5, 0.5),
                 "shift of both bodies against the grid; 0: they cross edges at the same time");
        o.number("t-end", t_end, "time", above(0), "end of the run");
    }

    double h() const { return length / cells; }
    double speed() const { return v0; }
    double wave_speed() const { return law().wave_speed(); }
    Law law() const { return {0, E / 2, rho}; }  // lambda + 2 mu = E: uniaxial stress
    double initial_energy() const { return rho * h() * v0 * v0; }

    /// Beyond both ends as far as the bodies can fly, and two cells more for the reach of the smooth functions.
    Lattice<1> lattice(int, int per_cell) const {
        const double flight = std::ceil(v0 * t_end / h());
        if (!(flight < 1e6))
            throw BadInput("--v0, --t-end: the bodies fly over " + std::to_string(flight) + " cells, at most 1e6 are allowed");
        const int pad = 2 + static_cast<int>(flight);
        return {Vec<1>(-pad * h()), Vec<1>(h()), {cells + 2 * pad}, per_cell};
    }

    template <class Point>
    std::vector<Point> particles(int, int ppc) const {
        const CellRule rule = middles(ppc);
        std::vector<Point> all;
        for (const int direction : {1, -1})
            for (std::size_t q = 0; q < rule.at.size(); ++q) {
                Point& p = all.emplace_back();
                const double from_end = rule.at[q] * h();
                p.X[0] = p.x[0] = (direction > 0 ? from_end : length - from_end) + offset * h();
                p.V = p.V0 = rule.part[q] * h();
                p.m = rho * p.V;
                p.v[0] = direction * v0;
            }
        return all;
    }
    template <class Points>
    static std::size_t inner(const Points& points) {
        return points.size() / 2 - 1;
    }

    template <class Body>
    void load(Body&, double) const {}
    template <class Grid, class Field>
    void fix(Grid&, Field, double) const {}

    template <class Points>
    std::array<double, 4> watch(const Points& points, double) const {
        const auto& p = points[inner(points)];
        return {p.x[0], p.v[0], p.sigma(0, 0), meter->rate};
    }

    /// Jumps in their own scales: v0/h, and the deceleration c v0/h of a body against a wall.
    struct Observer {
        const TwoBodies& scene;
        double strain = 0, v = 0;  // strain energy; velocity of the first body

        template <class Points>
        void sample(const Points& points, double t, double) {
            scene.meter->see(points, inner(points), t, scene.h());
            strain = v = 0;
            for (const auto& p : points) strain += scene.law().energy(p);
            for (std::size_t i = 0; i <= inner(points); ++i) v += points[i].v[0] / static_cast<double>(inner(points) + 1);
        }
        bool wants_energy(double, double) const { return false; }
        std::vector<NamedError> errors(double) const {
            const double rate = scene.v0 / scene.h();
            return {{"rate_jump", scene.meter->rate_jump / rate},
                    {"force_jump", scene.meter->force_jump / (rate * scene.wave_speed())},
                    {"strain_left", strain / scene.initial_energy()},
                    {"rebound", std::abs(1 + v / scene.v0)}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const { return {}; }
    };
};

}  // namespace mpm
