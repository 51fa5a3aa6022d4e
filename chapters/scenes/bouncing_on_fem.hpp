/// The disk that bounces on a plate of finite elements, to which the background grid is attached.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "chapters/scenes/bouncing_disk.hpp"
#include "chapters/scenes/graded.hpp"
#include "lab/rectilinear.hpp"

namespace mpm {

/// Background of 8 x 10 elements at J = 0, plate of 8 x 2. Steps are `far` in flight and `near` while the disk is within one layer of
/// elements of the plate; those between lead to that layer.
struct BouncingOnFem : BouncingDisk {
    static constexpr const char* name = "bouncing-on-fem";
    using Law = NeoHookean;

    int around = 300, layers = 22, thin = 1;
    double R0 = 0.14, far = 0.005, near = 0.0005;  // near: of this resolution
    double zone = 0;                               // height of the layer of this resolution

    void declare(Options& o) {
        BouncingDisk::declare(o);
        o.integer("around", around, "-", between(12, 100000), "particles on the core's outermost ring");
        o.integer("layers", layers, "-", between(1, 1000), "rings of particles between the core and the surface");
        o.number("far", far, "time", above(0), "time step in flight");
        o.integer("thin", thin, "rows", between(1, 64), "rows that take the place of the background's lowest: the disk feels the plate from there");
    }
    Law law() const { return law_of(E); }
    Law fem_law() const { return law_of(E_plate); }
    static int plate_rows(int cells) { return 2 << refinement(cells); }
    double layer(int cells) const { return above_plate / 10 / (1 << refinement(cells)) / thin; }

    std::array<Lines, 2> lines(int cells) const {
        const int J = refinement(cells);
        Lines y = halved(even_lines(-plate_height, 0, 2), J);
        const Lines background = halved(even_lines(0, above_plate, 10), J);
        const Lines lowest = even_lines(0, background[1], thin);
        y.insert(y.end(), lowest.begin() + 1, lowest.end());
        y.insert(y.end(), background.begin() + 2, background.end());
        return {halved(even_lines(0, width, 8), J), y};
    }
    std::vector<char> held(const Rectilinear<2>& grid) const { return face(grid, true); }
    std::vector<char> reset_held(const Rectilinear<2>& grid) const { return face(grid, false); }
    std::vector<int> fem_elements(const Rectilinear<2>& grid) const {
        std::vector<int> all(static_cast<std::size_t>(grid.elements(0) * plate_rows(grid.elements(0))));
        std::iota(all.begin(), all.end(), 0);
        return all;
    }
    Vec<2> body_force(double) const { return Vec<2>(0, -g); }
    Vec<2> fem_body_force(double) const { return Vec<2>::Zero(); }
    template <class Point> std::vector<Point> particles(int, int) const {
        std::vector<Point> all;
        for (const Placed& at : graded_disk(R, R0, around, layers)) {
            Point& p = all.emplace_back();
            p.x = p.X = centre() + at.x;
            p.V = p.V0 = at.V;
            p.m = rho * at.V;
        }
        return all;
    }

    template <class Points> State state(const Points& points) const {
        State s;
        for (const auto& p : points) s.add(p);
        s.close(R);
        return s;
    }
    template <class Points, class Plate> double step(const Points& points, const Plate&) const {
        const State s = state(points);
        const double room = s.lowest - zone;
        if (room <= 0) return near;
        return s.v < 0 ? std::clamp(-room / s.v, near, far) : far;
    }
    template <class Points, class Plate> std::array<double, 5> watch(const Points& points, const Plate& plate, double t) const {
        const State s = state(points);
        return {s.height, height_rigid(t), s.m * g * s.height, -plate.exchange().on_body[1], -plate.deepest(1)};
    }
    using Observer = BounceObserver<BouncingOnFem>;

private:
    static std::vector<char> face(const Rectilinear<2>& grid, bool lower) {
        std::vector<char> all(static_cast<std::size_t>(grid.size()) * 2, 0);
        std::fill_n(lower ? all.begin() : all.end() - 2 * grid.nodes(0), 2 * grid.nodes(0), 1);
        return all;
    }
};

}  // namespace mpm
