/// A short cantilever beam swings (Aulisa and Capodaglio, 6.2): gravity bends it until it turns, then it is left to itself.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/materials.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "chapters/scenes/graded.hpp"
#include "lab/boundary.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/rectilinear.hpp"

namespace mpm {

/// Clamped at x = 0; plane strain, g = 9.81 and a unit box are the grid. The gravity ends after the first step in which the tip comes back.
/// Its outer part may be stiffer: what swings then stays as slow, and the fastest wave does not.
struct Cantilever {
    static constexpr int D = 2;
    static constexpr const char* name = "cantilever";
    static constexpr const char* solves = "a short beam bends under its weight and is then left to swing";
    static constexpr const char* reference = "beam theory";
    static constexpr std::array<const char*, 2> columns{"tip", "gravity"};
    static constexpr bool may_break = true;  // a bent beam's surface has corners
    using Law = Materials<NeoHookean>;

    double E = 1.74e6, nu = 0.4, rho = 1e4, L = 0.625, H = 0.25, H0 = 0.15, g = 9.81;
    double contrast = 1, joint = 0.375;  // E beyond `joint` over that before it; a grid line of 8 cells
    double reference_frequency = 0;
    int rows = 20, layers = 20;
    mutable double released = std::numeric_limits<double>::infinity();  // when gravity ended, told by the observer

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/area", above(0), "density");
        o.number("g", g, "length/time^2", above(0), "gravity, until the tip turns");
        o.number("contrast", contrast, "-", above(0), "modulus of the outer part, x > 0.375, over that of the inner one");
        o.number("reference", reference_frequency, "1/time", at_least(0),
                 "frequency that the error is against; 0: beam theory with shear, which knows no contrast");
        o.integer("rows", rows, "-", between(3, 1000), "rows of particles in the core");
        o.integer("layers", layers, "-", between(1, 1000), "frames of particles between the core and the surface");
    }
    double mu() const { return E / (2 * (1 + nu)); }
    double lambda() const { return 2 * mu() * nu / (1 - 2 * nu); }
    Law law() const { return {{{lambda(), mu(), rho}, {contrast * lambda(), contrast * mu(), rho}}}; }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return 0; }

    std::array<Lines, 2> lines(int cells) const { return {even_lines(0, 1, cells), even_lines(-0.5, 0.5, cells)}; }
    std::vector<char> held(const Rectilinear<2>& grid) const {
        std::vector<char> all(static_cast<std::size_t>(grid.size()) * 2, 0);
        for (int I = 0; I < grid.size(); ++I)
            if (grid.along(I, 0) == 0) all[static_cast<std::size_t>(2 * I)] = all[static_cast<std::size_t>(2 * I + 1)] = 1;
        return all;
    }
    Lattice<2> lattice(int cells, int per_cell) const {
        return {Vec<2>(0, -0.5), Vec<2>::Constant(1.0 / cells), {cells, cells}, per_cell};
    }
    template <class Body> void load(Body& body, double t) const {
        const Vec<2> b = body_force(t);
        for (auto& node : body.grid) node.f += node.m * b;
    }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        for (int I = 0; I < grid.size(); I += grid.lattice().nodes(0)) (grid[I].*field).setZero();
    }
    template <class Grid> Vec<2> held_force(const Grid& grid) const {
        Vec<2> sum = Vec<2>::Zero();
        for (int I = 0; I < grid.size(); I += grid.lattice().nodes(0)) sum += grid[I].f;
        return sum;
    }
    template <class Bodies> Supply supply(const Bodies& bodies, double t, double dt) const {
        Supply sum;
        for (const auto* body : bodies)
            for (const auto& node : body->grid) sum.add(dt * node.m * body_force(t)[1], 1, node.v_new[1]);
        return sum;
    }
    Vec<2> body_force(double t) const { return t < released ? Vec<2>(0, -g) : Vec<2>(0, 0); }
    template <class Point> std::vector<Point> particles(int, int) const {
        std::vector<Point> all;
        for (const Placed& at : graded_beam(L, H, H0, rows, layers)) {
            Point& p = all.emplace_back();
            p.x = p.X = at.x;
            p.V = p.V0 = at.V;
            p.m = rho * at.V;
            p.material = at.x[0] > joint ? 1 : 0;
        }
        return all;
    }

    /// First frequency in plane strain: Euler and Bernoulli's, with the modulus E/(1 - nu^2), and with shear (Dunkerley, coefficient 5/6).
    double slender_frequency() const {
        const double stiff = E / (1 - nu * nu) * H * H / 12 / rho;
        return 1.8751 * 1.8751 / (2 * std::numbers::pi) * std::sqrt(stiff) / (L * L);
    }
    double frequency() const {
        const double shear = std::sqrt(5.0 / 6 * mu() / rho) / (4 * L), bend = slender_frequency();
        return 1 / std::sqrt(1 / (bend * bend) + 1 / (shear * shear));
    }

    double expected_frequency() const {
        if (reference_frequency > 0) return reference_frequency;
        return contrast == 1 ? frequency() : std::numeric_limits<double>::quiet_NaN();
    }

    /// Displacement across of the particle nearest to the middle of the free end.
    template <class Points> double tip(const Points& points) const {
        double nearest = 1e300, u = 0;
        for (const auto& p : points)
            if (const double d = (p.X - Vec<2>(L, 0)).squaredNorm(); d < nearest) nearest = d, u = p.x[1] - p.X[1];
        return u;
    }
    template <class Points> std::array<double, 2> watch(const Points& points, double t) const {
        return {tip(points), t < released ? g : 0};
    }

    /// Swings after the release: zeros and extremes of the tip, the latter by parabolas through three steps; energies at the release and at
    /// the end.
    struct Observer {
        const Cantilever& beam;
        std::vector<double> t{}, u{}, energy{};

        template <class Points> void sample(const Points& points, double now, double e) {
            const double tip = beam.tip(points);
            if (now < beam.released && u.size() > 1 && tip > u.back()) {  // it turns
                beam.released = now;
                t.clear(), u.clear();
            }
            t.push_back(now), u.push_back(tip);
            if (now >= beam.released) energy.push_back(e);
        }
        bool wants_energy(double, double) const { return true; }

        double frequency() const {
            double first = 0, last = 0;
            int zeros = 0;
            for (std::size_t n = 1; n < u.size(); ++n)
                if (u[n - 1] * u[n] < 0) {
                    last = t[n - 1] + (t[n] - t[n - 1]) * u[n - 1] / (u[n - 1] - u[n]);
                    if (zeros++ == 0) first = last;
                }
            return zeros > 1 ? (zeros - 1) / (2 * (last - first)) : std::numeric_limits<double>::quiet_NaN();
        }
        /// Part of the amplitude lost in a period: fit of ln |extreme| against time.
        double loss() const {
            double n = 0, st = 0, sl = 0, stt = 0, stl = 0;
            for (std::size_t k = 1; k + 1 < u.size(); ++k) {
                const double a = std::abs(u[k - 1]), b = std::abs(u[k]), c = std::abs(u[k + 1]);
                if (!(b >= a && b > c)) continue;
                const double top = b + (c - a) * (c - a) / (8 * (2 * b - a - c)), log_top = std::log(top);
                ++n, st += t[k], sl += log_top, stt += t[k] * t[k], stl += t[k] * log_top;
            }
            return 1 - std::exp((n * stl - st * sl) / (n * stt - st * st) / frequency());
        }
        std::vector<NamedError> errors(double) const {
            return {{"frequency", std::abs(frequency() / beam.expected_frequency() - 1)}, {"loss", std::abs(loss())}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            const double kept = energy.empty() ? std::numeric_limits<double>::quiet_NaN() : energy.back() / energy.front();
            return {{"gravity ended at t", beam.released},
                    {"frequency", frequency()},
                    {"beam theory with shear", beam.frequency()},
                    {"beam theory without", beam.slender_frequency()},
                    {"amplitude lost per period", loss()},
                    {"energy at the end / at the release", kept}};
        }
    };
};

}  // namespace mpm
