/// A block slides, or a disk rolls, down a slab at an angle (review 5.1): both bodies are elastic, the exact motion is that of rigid ones.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "lab/boundary.hpp"
#include "lab/contact_log.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"
#include "lab/rigid_body.hpp"

namespace mpm {

/// What the command line says of the slope.
struct SlopeSettings {
    double E = 1e6, nu = 0.3, rho = 1000, g = 10, angle = 30;        // modulus, ratio, density, gravity, slope [degrees]
    double slab_rho = 0;                                             // density of the slab; 0: that of the body
    double thickness = 0.4, gap = 0, rise = 0;                       // of the slab; at the start; time in which gravity comes on
    std::string grid = "aligned", placing = "cells";

    void declare(Options& o, bool disk) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = -1, .high = 0.5, .low_open = true, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/area", above(0), "density");
        o.number("g", g, "length/time^2", above(0), "gravity");
        o.number("angle", angle, "degrees", between(0, 80), "slope of the slab");
        o.number("rise", rise, "time", at_least(0), "time in which gravity smoothly comes on; 0: at once");
        o.number("thickness", thickness, "length", above(0), "thickness of the slab");
        o.number("clearance", gap, "length", at_least(0), "between body and slab at the start");
        o.number("slab-rho", slab_rho, "mass/area", at_least(0), "density of the slab; 0: that of the body");
        o.choice("grid", grid, {"aligned", "inclined"}, "the slab's face lies along the grid, or gravity does");
        if (disk) o.choice("placing", placing, {"cells", "rings"}, "particles of the disk: those of cells, or in rings about its centre");
    }
};

/// Block of 1 x 0.5 or disk of radius 0.5. Places are made in the frame of the slope: s downhill, q away from the slab.
struct Slope : SlopeSettings {
    static constexpr int D = 2;
    static constexpr const char* name = "slope";
    static constexpr const char* solves = "an elastic body slides or rolls down an elastic slab";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 8> columns{"travel", "travel_exact", "speed", "speed_exact",
                                                      "spin", "spin_exact", "friction", "supplied_work"};
    static constexpr bool may_break = true;  // particles of a pressed contact may leave cells without one
    using Law = NeoHookean;

    bool disk = false;
    double mu = 0.3, t_end = 1;  // of the contact; end of the run
    std::shared_ptr<ContactLog<2>> log = std::make_shared<ContactLog<2>>();

    Slope() = default;
    Slope(const SlopeSettings& settings, bool is_disk, double friction, double end, int cells)
        : SlopeSettings(settings), disk(is_disk), mu(friction), t_end(end) {
        const double a = angle * std::numbers::pi / 180;
        sin_ = std::sin(a), cos_ = std::cos(a);
        down_ = grid == "aligned" ? Vec<2>(1, 0) : Vec<2>(cos_, -sin_);
        up_ = Vec<2>(-down_[1], down_[0]);
        end_ = 1 + 1.1 * std::max(exact().travel(t_end), 0.1);
        for (const int axis : {0, 1})  // the slab's foot
            held_.hold_inside(lattice(cells, 1), HalfPlane{place(0, -thickness + (grid == "aligned" ? 1e-9 : 0.5) / cells), up_}, axis);
    }

    Law law() const {
        const double G = E / (2 * (1 + nu));
        return {2 * G * nu / (1 - 2 * nu), G, std::min(rho, slab_density())};
    }
    double slab_density() const { return slab_rho > 0 ? slab_rho : rho; }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return exact().speed(t_end); }

    /// Rigid motion: accelerations along the slope and about the centre, for gravity g.
    struct Motion {
        double a, alpha, rise;
        // Gravity over its final value is 3 r^2 - 2 r^3 with r = t/rise, as a Ramp; integrated twice.
        double since(double t) const { return Ramp<1>{Vec<1>(1), rise}.displacement(t)[0]; }
        double twice(double t) const {
            if (t >= rise) return 0.15 * rise * rise + 0.5 * (t * t - rise * t);
            const double r = t / rise;
            return rise * rise * r * r * r * r * (0.25 - 0.1 * r);
        }
        double speed(double t) const { return a * since(t); }
        double travel(double t) const { return a * twice(t); }
        double spin(double t) const { return alpha * since(t); }
    };
    /// A disk rolls up to tan = 3 mu, a block sticks up to tan = mu; steeper they slip.
    Motion exact() const {
        if (disk && sin_ <= 3 * mu * cos_) return {2 * g * sin_ / 3, 2 * g * sin_ / 3 / radius, rise};
        if (!disk && sin_ <= mu * cos_) return {0, 0, rise};
        return {g * (sin_ - mu * cos_), disk ? 2 * mu * g * cos_ / radius : 0, rise};
    }
    double mass() const { return rho * (disk ? std::numbers::pi * radius * radius : 0.5); }
    double free_travel(double t) const { return Motion{g * sin_, 0, rise}.travel(t); }

    Lattice<2> lattice(int cells, int per_cell) const {
        const double h = 1.0 / cells;
        Vec<2> low = Vec<2>::Constant(1e300), high = -low;
        for (const double s : {begin_, end_})
            for (const double q : {-thickness, gap + 2 * radius + 0.2}) {
                low = low.cwiseMin(place(s, q)), high = high.cwiseMax(place(s, q));
            }
        const Vec<2> first = (low * cells).array().floor() - 3, last = (high * cells).array().ceil() + 3;
        if (!((last - first).maxCoeff() < 1e4)) throw BadInput("--t-end, --g, --rise: the body travels over more than 1e4 cells");
        return {first * h, Vec<2>::Constant(h), {static_cast<int>(last[0] - first[0]), static_cast<int>(last[1] - first[1])}, per_cell};
    }

    template <class Point> std::vector<std::vector<Point>> bodies(int cells, int ppc) const {
        const double h = 1.0 / cells;
        std::vector<Point> body, slab = box<Point>({begin_, -thickness}, {end_, 0}, h / ppc, slab_density());
        if (!disk) body = box<Point>({-0.5, gap}, {0.5, gap + 0.5}, h / ppc, rho);
        else if (placing == "rings") body = rings<Point>(place(0, gap + radius), radius, h / ppc, rho);
        else
            for (const Point& p : box<Point>({-radius, gap}, {radius, gap + 2 * radius}, h / ppc, rho))
                if ((p.x - place(0, gap + radius)).norm() <= radius) body.push_back(p);
        if (body.empty()) throw BadInput("--cells, --ppc: no particle lies inside the body");
        return {body, slab};
    }

    template <class Body> void load(Body& body, double t) const {
        const Vec<2> b = gravity(t);
        for (auto& node : body.grid) node.f += node.m * b;
    }
    template <class Grid, class Field> void fix(Grid& nodes, Field field, double) const { held_.apply(nodes, field); }

    /// Impulse and work of gravity and of the slab's foot.
    template <class Bodies> Supply supply(const Bodies& bodies, double t, double dt) {
        Supply sum;
        const Vec<2> b = gravity(t);
        for (const auto* body : bodies) {
            for (const auto& node : body->grid)
                for (const int d : {0, 1}) sum.add(dt * node.m * b[d], d, 0.5 * (node.v[d] + node.v_new[d]));
            sum += held_.supply(body->grid, dt);
        }
        work_ += sum.work;
        return sum;
    }

    struct State {
        double travel = 0, speed = 0, spin = 0;
    };
    /// How far a block's lowest particles have slipped along those of the slab under them.
    template <class Points> double slip(const Points& points) const {
        double above = 0, below = 0, m_above = 0, m_below = 0;
        for (const auto& p : points) {
            const double q = p.X.dot(up_), size = std::sqrt(p.V0), u = p.m * (p.x - p.X).dot(down_);
            if (std::abs(p.X.dot(down_)) > 0.5) continue;
            if (q > 0 && q < gap + size) above += u, m_above += p.m;
            if (q < 0 && q > -size) below += u, m_below += p.m;
        }
        return above / m_above - below / m_below;
    }
    /// Of the body alone, from its particles: those that started above the slab.
    template <class Points> State state(const Points& points) const {
        double m = 0, J = 0, L = 0;
        Vec<2> x = Vec<2>::Zero(), u = x, v = x;
        const auto each = [&](auto&& visit) {
            for (const auto& p : points)
                if (p.X.dot(up_) > 0) visit(p);
        };
        each([&](const auto& p) { m += p.m, x += p.m * p.x, u += p.m * (p.x - p.X), v += p.m * p.v; });
        x /= m, u /= m, v /= m;
        each([&](const auto& p) {
            const Vec<2> r = p.x - x, w = p.v - v;
            J += p.m * r.squaredNorm(), L += p.m * (r[1] * w[0] - r[0] * w[1]);
        });
        return {u.dot(down_), v.dot(down_), L / J};  // spin is positive downhill
    }
    template <class Points> std::array<double, 8> watch(const Points& points, double t) const {
        const State now = state(points);
        const Motion rigid = exact();
        return {now.travel, rigid.travel(t), now.speed, rigid.speed(t), now.spin, rigid.spin(t), log->friction, work_};
    }

    struct Observer {
        const Slope& scene;
        State end{};
        double t = 0, slip = 0;

        template <class Points> void sample(const Points& points, double now, double) {
            t = now;
            if (now >= scene.t_end * (1 - 1e-9)) end = scene.state(points), slip = scene.slip(points);
        }
        bool wants_energy(double, double) const { return false; }
        std::vector<NamedError> errors(double) const {
            const double exact = scene.exact().travel(t), spin = scene.exact().spin(t);
            if (exact == 0) return {{"creep", std::abs(slip) / scene.free_travel(t)}};
            std::vector<NamedError> all{{"travel", std::abs(end.travel / exact - 1)}};
            if (spin != 0) all.push_back({"spin", std::abs(end.spin / spin - 1)});
            return all;
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            const double exact = scene.exact().travel(t);
            const ContactLog<2>& log = *scene.log;
            return {{"travel / exact - 1", exact > 0 ? end.travel / exact - 1 : std::numeric_limits<double>::quiet_NaN()},
                    {"friction over normal impulses", log.rubbed / log.pressed},
                    {"momentum made by contact / weight impulse", log.made.norm() / (scene.g * t * scene.mass())},
                    {"shared nodes a step", static_cast<double>(log.nodes) / static_cast<double>(std::max(1L, log.steps))},
                    {"pairs without a normal", static_cast<double>(log.without_normal)},
                    {"energy that friction took", log.friction},
                    {"energy that normal impulses took", log.normal}};
        }
    };

private:
    static constexpr double radius = 0.5, begin_ = -1;

    Vec<2> place(double s, double q) const { return s * down_ + q * up_; }
    Vec<2> gravity(double t) const { return Ramp<1>{Vec<1>(g), rise}.velocity(t)[0] * (sin_ * down_ - cos_ * up_); }

    /// Particles of a rectangle in the slope's frame, in rows along it.
    template <class Point> std::vector<Point> box(const Vec<2>& low, const Vec<2>& high, double size, double density) const {
        std::vector<Point> all;
        const Vec<2> n = ((high - low) / size).array().round().max(1.0);
        const Vec<2> l = (high - low).cwiseQuotient(n);
        for (int j = 0; j < static_cast<int>(n[1]); ++j)
            for (int i = 0; i < static_cast<int>(n[0]); ++i)
                all.push_back(particle_at<Point>(place(low[0] + (i + 0.5) * l[0], low[1] + (j + 0.5) * l[1]), l.prod(), density));
        return all;
    }

    double sin_ = 0, cos_ = 1, end_ = 2, work_ = 0;
    Vec<2> down_ = Vec<2>(1, 0), up_ = Vec<2>(0, 1);
    Dirichlet held_;
};

}  // namespace mpm
