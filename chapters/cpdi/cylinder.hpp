/// A quarter of a thick cylinder under inner pressure (chapters/scenes/pressed_cylinder.hpp), tessellated into domains whose edges are
/// loaded (review 4.2.3). It comes to rest by damping.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "chapters/cpdi/edge_traction.hpp"
#include "chapters/cpdi/tessellated.hpp"
#include "chapters/material/one_of.hpp"
#include "chapters/scenes/pressed_cylinder.hpp"
#include "lab/monitor.hpp"
#include "lab/norms.hpp"
#include "lab/structured.hpp"

namespace mpm {

/// For updated-Lagrangian schemes with domains.
struct PressedCylinder : CylinderCase, Tessellated {
    static constexpr int D = 2;
    static constexpr const char* name = "pressed-cylinder";
    static constexpr const char* solves = "quarter of a thick cylinder under inner pressure, plane strain";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 2> columns{"u_mean", "u_mean_exact"};
    using Law = OneOf<NeoHookean, Hooke>;

    std::vector<LoadedEdge> edges = {};
    PolygonCells (*polygons)(const Quadrilaterals& polar, const CellCounts& n) = nullptr;  // needs a mesher

    explicit PressedCylinder(const CylinderCase& data) : CylinderCase(data) {}

    Law law() const { return {CylinderCase::law, lambda(), mu(), rho}; }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return 0; }

    /// Its lines 0 are the planes of symmetry. There is a cell beyond the outer radius, and more if the pressure drives it far.
    Lattice<2> lattice(int cells, int per_cell) const {
        const double h = b / cells, far = std::abs(displacement(b)) / h;
        if (!(far < 10 * cells))
            throw BadInput("--pressure = " + number_text(p) + ": it would move the outer radius by more than ten times itself");
        const int all = cells + 2 + static_cast<int>(4 * far);
        return {Vec<2>::Zero(), Vec<2>::Constant(h), {all, all}, per_cell};
    }

    /// Domains across the wall and around, about ppc x ppc of them in a cell.
    CellCounts counts(int cells, int ppc) const {
        const auto fitting = [&](double length) { return std::max(1, static_cast<int>(std::lround(length * cells * ppc / b))); };
        return {fitting(b - a), fitting((a + b) / 2 * std::numbers::pi / 2)};
    }
    /// Polar quadrilaterals, or these halved into triangles, or what `polygons` makes within their outline; notes which edges are loaded.
    std::vector<PolygonCells> tessellate(const std::string& shape, int cells, int ppc) {
        const CellCounts n = counts(cells, ppc);
        const Quadrilaterals polar = quadrilaterals_of(Ring{Vec<2>::Zero(), a, b}, n, 0, std::numbers::pi / 2);
        PolygonCells mesh;
        if (shape == DomainT3::name) mesh = polygon_cells(triangles_of(polar, n, Diagonals::alternating));
        else if (shape == DomainPolygon::name) mesh = polygons(polar, n);
        else mesh = polygon_cells(polar);
        mesh = counter_clockwise(std::move(mesh));
        const double tolerance = 0.1 * (b - a) / n.first;
        edges = boundary_edges(mesh, [&](const Vec<2>& x) { return x.norm() < a + tolerance; });
        return {mesh};
    }
    template <class Point> std::vector<std::vector<Point>> bodies(int, int) const {
        return bodies_of<Point>(rho, [](Point&) {});
    }

    /// The pressure, and the damping -2 omega m v of each node.
    template <class Body> void load(Body& body, double t) const {
        auto& grid = body.grid;
        using Node = typename Body::Node;
        fix(grid, &Node::mv, t);
        for (auto& node : grid) node.f -= drag() * node.mv;
        pushes->clear();
        const auto push = [&](int I, const Vec<2>& f) {
            grid[I].f += f;
            pushes->emplace_back(I, f);
        };
        if (load_kind == "dead") each_edge_force(edges, body.shape.corners(), DeadPressure{p}, push);
        else each_edge_force(edges, body.shape.corners(), FollowerPressure{p}, push);
    }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        on_planes(grid.lattice(), [&](int I, int axis) { (grid[I].*field)[axis] = 0; });
    }
    template <class Grid> Vec<2> held_force(const Grid& grid) const {
        Vec<2> sum = Vec<2>::Zero();
        on_planes(grid.lattice(), [&](int I, int axis) { sum[axis] += grid[I].f[axis]; });
        return sum;
    }
    template <class Bodies> Supply supply(const Bodies& bodies, double, double dt) const {
        Supply sum;
        const auto& grid = bodies[0]->grid;
        const auto add = [&](const Vec<2>& f, const Vec<2>& v) {
            for (const int d : {0, 1}) sum.add(dt * f[d], d, v[d]);
        };
        for (const auto& [I, f] : *pushes) add(f, grid[I].v_new);
        for (const auto& node : grid) add(-drag() * node.mv, node.v_new);
        return sum;
    }

    /// Radial displacement, the mean over the mass, and Lame's.
    template <class Points> std::array<double, 2> watch(const Points& points, double) const {
        double u = 0, exact = 0, m = 0;
        for (const auto& q : points) {
            u += q.m * (q.x - q.X).dot(q.X.normalized()), exact += q.m * displacement(q.X.norm());
            m += q.m;
        }
        return {u / m, exact / m};
    }

    /// Errors at the end: relative L2 over the domains.
    struct Observer {
        const PressedCylinder& scene;
        std::array<double, 3> difference2{}, exact2{};  // of displacement, hoop and radial stress

        template <class Points> void sample(const Points& points, double, double energy) {
            if (std::isnan(energy)) return;
            difference2 = exact2 = {};
            for (const auto& q : points) {
                const double r = q.X.norm();
                const Vec<2> e = q.X / r, around(-e[1], e[0]);
                const auto add = [&](std::size_t k, double off2, double exact) {
                    difference2[k] += q.V0 * off2, exact2[k] += q.V0 * exact * exact;
                };
                const auto off = [&](const Vec<2>& n, double exact) { return std::pow(n.dot(q.sigma * n) - exact, 2); };
                add(0, (q.x - q.X - scene.displacement(r) * e).squaredNorm(), scene.displacement(r));
                add(1, off(around, scene.hoop(r)), scene.hoop(r));
                add(2, off(e, scene.radial(r)), scene.radial(r));
            }
        }
        bool wants_energy(double t, double t_end) const { return t >= t_end * (1 - 1e-12); }
        double error(std::size_t k) const { return std::sqrt(difference2[k] / exact2[k]); }
        std::vector<NamedError> errors(double) const { return {{"displacement", error(0)}, {"hoop", error(1)}, {"radial", error(2)}}; }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"displacement, relative L2 error", error(0)}, {"hoop stress", error(1)}, {"radial stress", error(2)}};
        }
    };

private:
    double drag() const { return 2 * damping * omega(); }
    /// Nodes on the planes of symmetry and their axes: the first row and column of the grid.
    template <class Visit> void on_planes(const Lattice<2>& lattice, Visit&& visit) const {
        for (int k = 0; k < lattice.nodes(0); ++k) visit(k, 1);
        for (int k = 0; k < lattice.nodes(1); ++k) visit(k * lattice.nodes(0), 0);
    }
    using NodalForces = std::vector<std::pair<int, Vec<2>>>;
    std::shared_ptr<NodalForces> pushes = std::make_shared<NodalForces>();  // of the last step, for `supply`
};

}  // namespace mpm
