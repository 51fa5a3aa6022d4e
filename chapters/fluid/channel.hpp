/// Viscous flow between two plates that starts from rest: driven by the upper plate (Couette) or by a body force (Poiseuille), against the
/// exact solution: the heat of a slab (chapters/scenes/slab_exact.hpp).
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "chapters/fluid/liquid.hpp"
#include "chapters/scenes/slab_exact.hpp"
#include "lab/boundary.hpp"
#include "lab/figure.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/record.hpp"

namespace mpm {

struct ChannelSettings : LiquidSettings {
    double height = 1, U = 1;  // between the plates; velocity
    std::string flow = "couette";

    ChannelSettings() { kappa = 100, rho = 1, mu = 1; }
    void declare(Options& o) {
        LiquidSettings::declare(o);
        o.number("height", height, "length", above(0), "distance of the plates; --cells go across it");
        o.number("U", U, "length/time", above(0), "velocity of the upper plate, or of the middle of the steady Poiseuille flow");
        o.choice("flow", flow, {"couette", "poiseuille"}, "driven by the upper plate, or by a body force between plates at rest");
    }
    double nu() const { return mu / rho; }
    bool couette() const { return flow == "couette"; }
    double body_force() const { return couette() ? 0 : 8 * nu() * U / (height * height); }  // acceleration along the channel
};

/// The flow does not change along the channel, and here it cannot: the nodes of each row of the grid move as one, with the mean velocity
/// of their masses. That is the flow in a channel without ends, and what is tested is how shear spreads across the cells, while
/// particles pass from cell to cell along them. Two columns of cells start filled; the grid is as long as the way of the fastest.
///
/// A plate is a row of nodes that has its velocity U. Functions wider than a cell reach past it, and what they would give to the flow's
/// image, which moves with 2 U - v, is made good as at a plane of symmetry (lab/boundary.hpp). With the plate at the grid's end instead,
/// folded functions are not symmetric about their nodes, the lumped second mapping gives such a node the momentum of a place beside it,
/// and cubic functions lose their order there (1.2 instead of 2).
struct Channel : ChannelSettings {
    static constexpr int D = 2;
    static constexpr const char* name = "channel";
    static constexpr const char* solves = "flow between two plates, started from rest";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 2> columns{"v_mean", "v_mean_exact"};
    static constexpr bool may_break = true;  // shear parts the ends of the two columns, and nothing is lost by it
    using Law = Newtonian;

    double h = 1, t_end = 0.1;  // [length], [time]

    Channel() = default;
    Channel(const ChannelSettings& settings, int cells, double end) : ChannelSettings(settings), h(settings.height / cells), t_end(end) {}

    Law law() const { return liquid(); }
    double wave_speed() const { return law().signal_speed(law().wave_speed(), h); }
    double speed() const { return U; }
    Animated animated() const { return {"x", "y", "vx", "x [length]", "y [length]", "velocity [length/time]"}; }

    /// Velocity at height y after t > 0, and its mean.
    double exact(double y, double t) const {
        return couette() ? U * slab::between_held_ends(y / height, Fo(t)) : 8 * U * slab::heated_evenly(y / height, Fo(t));
    }
    double exact_mean(double t) const { return couette() ? U * slab::between_held_ends_mean(Fo(t)) : 8 * U * slab::heated_evenly_mean(Fo(t)); }

    static constexpr int filled = 2, outside = 2;  // columns of cells with particles; without, at both ends
    static constexpr int below = 1;                // rows of cells beyond each plate
    Lattice<2> lattice(int cells, int per_cell) const {
        const double way = std::ceil(U * t_end / h);
        if (!(way * cells < 1e7)) throw BadInput("--U, --t-end: the flow goes over " + number_text(way) + " cells");
        return {Vec<2>(-outside * h, -below * h),
                Vec<2>::Constant(h),
                {filled + 2 * outside + static_cast<int>(way), cells + 2 * below},
                per_cell};
    }
    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        std::vector<Point> all;
        const double s = h / ppc;
        for (int j = 0; j < cells * ppc; ++j)
            for (int i = 0; i < filled * ppc; ++i) {
                Point& p = all.emplace_back();
                p.X = p.x = Vec<2>((i + 0.5) * s, (j + 0.5) * s);
                p.V0 = p.V = s * s;
                p.m = rho * p.V0;
            }
        return all;
    }

    template <class Body> void load(Body& body, double) const { force().load(body.grid); }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double t) const {
        const int wide = grid.lattice().nodes(0), top = grid.lattice().nodes(1) - 1 - below;
        const auto move = [&](int j, const Vec<2>& v) {
            for (int i = 0; i < wide; ++i) grid[j * wide + i].*field = grid[j * wide + i].m * v;
        };
        for (int j = below + 2; j <= top - 2; ++j) move(j, sum_of(grid, j, field).v);
        for (const auto& [plate, out, speed_of_plate] : {std::tuple{below, -1, 0.0}, std::tuple{top, 1, lid(t)}}) {
            const Vec<2> u(speed_of_plate, 0);
            const Row outer = sum_of(grid, plate + out, field);
            Row inner = sum_of(grid, plate - out, field);
            if (outer.m > 0) inner.v = (inner.m * inner.v + outer.m * (2 * u - outer.v)) / (inner.m + outer.m);
            move(plate, u);
            move(plate - out, inner.v);
            move(plate + out, 2 * u - inner.v);
        }
    }
    /// Impulse and work of the body force and, in the half of the channel beside each, of the plates: all that nodes got besides their
    /// forces.
    template <class Bodies> Supply supply(const Bodies& bodies, double t, double dt) const {
        Supply sum;
        for (const auto* body : bodies) {
            const auto& grid = body->grid;
            sum += force().supply(grid, dt);
            for (int I = 0; I < grid.size(); ++I) {
                const double beside = 2 * grid.lattice().position(I)[1] > height ? lid(t + dt) : 0;
                const Vec<2> given = grid[I].m * (moving_velocity(grid[I]) - grid[I].v) - dt * grid[I].f;
                sum.add(given[0], 0, beside);
                sum.add(given[1], 1, 0);
            }
        }
        return sum;
    }

    template <class Points> std::array<double, 2> watch(const Points& points, double t) const {
        double m = 0, mv = 0;
        for (const auto& p : points) m += p.m, mv += p.m * p.v[0];
        return {mv / m, t > 0 ? exact_mean(t) : 0};
    }

    /// Root mean square difference of the particles' velocities from the exact ones at the end, by U; and how far the density has moved.
    struct Observer {
        const Channel& scene;
        double square = 0, worst = 0, compression = 0;

        template <class Points> void sample(const Points& points, double t, double energy) {
            if (std::isnan(energy)) return;
            for (const auto& p : points) {
                const double error = std::abs(p.v[0] - scene.exact(p.x[1], t)) / scene.U;
                square += error * error / static_cast<double>(points.size());
                worst = std::max(worst, error);
                compression = std::max(compression, std::abs(p.V / p.V0 - 1));
            }
        }
        bool wants_energy(double t, double t_end) const { return t > 0 && t >= t_end * (1 - 1e-12); }
        std::vector<NamedError> errors(double) const { return {{"v_rms", std::sqrt(square)}, {"v_max", worst}}; }
        std::vector<std::pair<std::string, double>> facts(double t_end) const {
            return {{"nu t/H^2 at the end", scene.Fo(t_end)},
                    {"rms error of velocity / U", std::sqrt(square)},
                    {"largest error of velocity / U", worst},
                    {"largest |J - 1|", compression}};
        }
    };

private:
    struct Row {
        double m = 0;
        Vec<2> v = Vec<2>::Zero();  // mean velocity
    };
    template <class Grid, class Field> static Row sum_of(const Grid& grid, int j, Field field) {
        const int wide = grid.lattice().nodes(0);
        Row row;
        for (int i = 0; i < wide; ++i) row.m += grid[j * wide + i].m, row.v += grid[j * wide + i].*field;
        if (row.m > 0) row.v /= row.m;
        return row;
    }

    Gravity<2> force() const { return {Vec<2>(body_force(), 0)}; }
    /// The plate is at rest at t = 0: FLIP carries changes of nodal velocities, and without the first one, particles beside the plate would
    /// stay behind for ever.
    double lid(double t) const { return couette() && t > 0 ? U : 0; }
    double Fo(double t) const { return nu() * t / (height * height); }
};

}  // namespace mpm
