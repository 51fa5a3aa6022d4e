/// A compliant column that hangs from its top in strong gravity (review 3.6.2, figure 25), tessellated into particle domains.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "chapters/scenes/column_exact.hpp"
#include "lab/boundary.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"
#include "lab/structured.hpp"
#include "lab/tessellated.hpp"

namespace mpm {

/// What the command line says of the column. The review gives no numbers; the defaults are those of the bar for which CPDI was
/// introduced (Sadeghirad et al. 2011), 1 m x 1 m, with a quarter of its gravity.
struct HeavyColumnSettings {
    double E = 1e6, nu = 0.3, rho = 1050, gravity = 250, length = 1, width = 1, damping = 0;
    std::string sides = "free";

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/area", above(0), "density");
        o.number("g", gravity, "length/time^2", above(0), "gravity, which sets in at once");
        o.number("length", length, "length", above(0), "length of the column, which hangs from y = 0");
        o.number("width", width, "length", above(0), "width of the column");
        o.choice("sides", sides, {"free", "held"}, "held: no lateral motion anywhere, uniaxial strain, whose state of rest is exact");
        o.number("damping", damping, "-", {.low = 0, .high = 1, .high_open = true},
                 "local damping: this part of a node's force, against its velocity");
    }
    double mu() const { return E / (2 * (1 + nu)); }
    double lambda() const { return 2 * mu() * nu / (1 - 2 * nu); }
};

/// Nodes on the line y = 0 and above it are at rest.
struct HeavyColumn : HeavyColumnSettings, Tessellated {
    static constexpr int D = 2;
    static constexpr const char* name = "heavy-column";
    static constexpr const char* solves = "a compliant column hangs from its top in gravity that sets in at once";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 2> columns{"tip", "tip_static"};
    static constexpr bool may_break = true;  // domains longer than a cell leave cells without a particle, but not without weight
    static constexpr bool numbered = true;   // particle i is that of domain i
    using Law = NeoHookean;

    /// Cells of a box, so many along each axis.
    std::function<PolygonCells(const Box& box, const CellCounts& counts)> mesh_of = {};

    Law law() const { return {lambda(), mu(), rho}; }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return 0; }
    bool held_sides() const { return sides == "held"; }
    Box box() const { return {Vec<2>(0, -length), Vec<2>(width, 0)}; }
    double h(int cells) const { return std::max(length, width) / cells; }

    /// Room for five times the sag of a linear column in plane stress across, twice what it swings to, and on all sides for domains that
    /// swell.
    Lattice<2> lattice(int cells, int per_cell) const {
        const double size = h(cells), sag = rho * gravity * length * length * (1 - nu * nu) / (2 * E);
        const double below = std::ceil((length + 5 * sag) / size);
        if (!(below < 1e5))
            throw BadInput("--g, --E, --length: the column sags over " + number_text(below) + " cells, at most 1e5 are allowed");
        const int across = static_cast<int>(std::ceil(width / size - 1e-9)), pad = 2 + cells / 4, down = static_cast<int>(below) + 2;
        return {Vec<2>(-pad * size, -down * size), Vec<2>::Constant(size), {across + 2 * pad, down + 2}, per_cell};
    }
    std::vector<PolygonCells> tessellate(const std::string&, int cells, int ppc) {
        const auto count = [&](double side) { return std::max(1, static_cast<int>(std::lround(side / h(cells) * ppc))); };
        PolygonCells mesh = mesh_of(box(), {count(width), count(length)});
        find_lower_edges(mesh);
        const Lattice<2> grid = lattice(cells, 1);
        for (const int axis : {0, 1}) held_.hold_plane(grid, 1, 0, false, axis);
        if (held_sides()) held_.hold_inside(grid, Box{grid.origin(), grid.upper()}, 0);
        return {mesh};
    }
    template <class Point> std::vector<std::vector<Point>> bodies(int, int) const {
        return bodies_of<Point>(rho, [](Point&) {});
    }

    template <class Body> void load(Body& body, double) const {
        for (auto& node : body.grid) node.f[1] -= node.m * gravity;
        if (damping > 0) each_free(body.grid, [&](auto& node, int axis) { node.f[axis] += damping_force(node.f[axis], node.mv[axis]); });
    }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const { held_.apply(grid, field); }

    /// Impulse and work of gravity, damping and held nodes, with the velocities that strain particles.
    template <class Bodies> Supply supply(const Bodies& bodies, double, double dt) const {
        Supply sum;
        for (const auto* body : bodies) {
            for (const auto& node : body->grid) sum.add(-dt * node.m * gravity, 1, node.v_new[1]);
            if (damping > 0)
                each_free(body->grid, [&](const auto& node, int axis) {
                    const double f = node.f[axis], undamped = f / (f * node.mv[axis] > 0 ? 1 - damping : 1 + damping);
                    sum.add(dt * damping_force(undamped, node.mv[axis]), axis, node.v_new[axis]);
                });
            sum += held_.supply(body->grid, dt);
        }
        return sum;
    }

    /// Downward displacement of the middle of the lower end: linear between the middles of the two domains' edges next to it, which move
    /// with their particles and these particles' F.
    template <class Points> double tip(const Points& points) const {
        const auto sag = [&](const LowerEdge& edge) {
            const auto& p = points[edge.particle];
            return -(p.x - p.X + (p.F - identity<2>()) * (edge.middle - p.X))[1];
        };
        std::size_t above = std::min<std::size_t>(1, lower_.size() - 1);
        while (above + 1 < lower_.size() && lower_[above].middle[0] < width / 2) ++above;
        if (above == 0) return sag(lower_[0]);
        const LowerEdge &left = lower_[above - 1], &right = lower_[above];
        const double part = (width / 2 - left.middle[0]) / (right.middle[0] - left.middle[0]);
        return (1 - part) * sag(left) + part * sag(right);
    }
    /// The same at rest with held sides: a neo-Hookean bar under its own weight.
    double static_tip() const {
        if (!held_sides()) return std::numeric_limits<double>::quiet_NaN();
        const Law solid = law();
        return ColumnAtRest<Law>{solid, length, 0, rho * gravity}.displacement(length);
    }
    template <class Points> std::array<double, 2> watch(const Points& points, double) const { return {tip(points), static_tip()}; }

    struct Observer {
        const HeavyColumn& scene;
        double now = 0, peak = 0, t_peak = 0, stretch = 0;  // tip, its largest value and when; largest component of F

        template <class Points> void sample(const Points& points, double t, double) {
            now = scene.tip(points);
            if (now > peak) peak = now, t_peak = t;
            for (const auto& p : points) stretch = std::max(stretch, p.F.cwiseAbs().maxCoeff());
        }
        bool wants_energy(double, double) const { return false; }
        std::vector<NamedError> errors(double) const { return {{"tip_static", std::abs(now / scene.static_tip() - 1)}}; }
        std::vector<std::pair<std::string, double>> facts(double) const {
            std::vector<std::pair<std::string, double>> all{
                {"tip at the end", now}, {"largest tip", peak}, {"at t", t_peak}, {"largest component of F", stretch}};
            if (scene.held_sides()) all.insert(all.begin() + 1, {"tip at rest, exact", scene.static_tip()});
            return all;
        }
    };

private:
    struct LowerEdge {
        std::size_t particle;
        Vec<2> middle;
    };
    void find_lower_edges(const PolygonCells& mesh) {
        lower_.clear();
        for (std::size_t i = 0; i < mesh.corners.size(); ++i)
            for (std::size_t c = 0; c < mesh.corners[i].size(); ++c) {
                const auto& cell = mesh.corners[i];
                const auto corner = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(cell[k % cell.size()])]; };
                const Vec<2> a = corner(c), b = corner(c + 1);
                if (std::max(a[1], b[1]) < -length * (1 - 1e-9)) lower_.push_back({i, (a + b) / 2});
            }
        std::sort(lower_.begin(), lower_.end(), [](const LowerEdge& a, const LowerEdge& b) { return a.middle[0] < b.middle[0]; });
    }
    /// Al-Kafaji (2013), review remark 19: it vanishes at rest.
    double damping_force(double f, double mv) const { return mv == 0 ? 0 : -std::copysign(damping * std::abs(f), mv); }
    /// Visits the velocity components that nothing holds; `held_` is sorted by node and axis.
    template <class Grid, class Visit> void each_free(Grid& grid, Visit&& visit) const {
        auto next = held_.held.begin();
        for (int I = 0; I < grid.size(); ++I)
            for (const int axis : {0, 1}) {
                if (next != held_.held.end() && next->node == I && next->axis == axis) ++next;
                else visit(grid[I], axis);
            }
    }

    std::vector<LowerEdge> lower_;  // from left to right
    Dirichlet held_;
};

}  // namespace mpm
