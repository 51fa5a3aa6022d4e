/// The disk that bounces on a plate of particles: the explicit way, by contact on the grid.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "chapters/material/materials.hpp"
#include "chapters/scenes/bouncing_disk.hpp"
#include "lab/boundary.hpp"
#include "lab/contact_log.hpp"
#include "lab/fill.hpp"

namespace mpm {

/// Disk and plate are bodies with fields of their own on square cells, as many along the plate as that of finite elements has; the disk's
/// particles lie in rings.
struct BouncingOnParticles : BouncingDisk {
    static constexpr const char* name = "bouncing-on-particles";
    using Law = Materials<NeoHookean>;

    Dirichlet held = {};
    std::shared_ptr<ContactLog<2>> log = std::make_shared<ContactLog<2>>();
    struct Told {
        double t = 0, pressed = 0;
    };
    std::shared_ptr<Told> told = std::make_shared<Told>();  // of the last record, to make a force of impulses

    /// For this resolution.
    void start(int cells) {
        log = std::make_shared<ContactLog<2>>();
        told = std::make_shared<Told>();
        for (const int axis : {0, 1}) held.hold_plane(lattice(cells, 1), 1, -plate_height, true, axis);
    }
    Law law() const { return {{law_of(E), law_of(E_plate)}}; }
    Lattice<2> lattice(int cells, int per_cell) const {
        const int pad = 4, high = static_cast<int>(std::ceil(above_plate / width * cells)) + pad, deep = cells / 8 + pad;
        const double h = width / cells;
        return {Vec<2>(-pad * h, -deep * h), Vec<2>::Constant(h), {cells + 2 * pad, deep + high}, per_cell};
    }
    template <class Point> std::vector<std::vector<Point>> bodies(int cells, int ppc) const {
        std::vector<Point> disk = rings<Point>(centre(), R, width / cells / ppc, rho);
        const Box box{Vec<2>(0, -plate_height), Vec<2>(width, 0)};
        std::vector<Point> plate = particles_inside<Point>(box, lattice(cells, 1), middles(ppc), rho);
        for (Point& p : plate) p.material = 1;
        return {disk, plate};
    }
    template <class Body> void load(Body& body, double) const {
        if (body.points.front().material != 0) return;
        for (auto& node : body.grid) node.f[1] -= node.m * g;
    }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const { held.apply(grid, field); }
    template <class Bodies> Supply supply(const Bodies& all, double, double dt) const {
        Supply sum;
        for (const auto* body : all) {
            sum += held.supply(body->grid, dt);
            if (body->points.front().material != 0) continue;
            for (const auto& node : body->grid) sum.add(-dt * node.m * g, 1, 0.5 * (node.v[1] + node.v_new[1]));
        }
        return sum;
    }

    template <class Points> State state(const Points& points) const {
        State s;
        for (const auto& p : points)
            if (p.material == 0) s.add(p);
        s.close(R);
        return s;
    }
    template <class Points> std::array<double, 5> watch(const Points& points, double t) const {
        const State s = state(points);
        double sinking = 0;
        for (const auto& p : points)
            if (p.material == 1) sinking = std::max(sinking, p.X[1] - p.x[1]);
        const double force = t > told->t ? (log->pressed - told->pressed) / (t - told->t) : 0;
        *told = {t, log->pressed};
        return {s.height, height_rigid(t), s.m * g * s.height, force, sinking};
    }
    using Observer = BounceObserver<BouncingOnParticles>;
};

}  // namespace mpm
