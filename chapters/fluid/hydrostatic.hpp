/// A column of liquid at rest between slip walls under gravity: the pressure is the weight above.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "chapters/fluid/liquid.hpp"
#include "lab/boundary.hpp"
#include "lab/fill.hpp"
#include "lab/figure.hpp"
#include "lab/norms.hpp"
#include "lab/record.hpp"

namespace mpm {

struct HydrostaticSettings : LiquidSettings {
    double height = 1, width = 0.5, g = 9.81;
    std::string start = "rest";

    void declare(Options& o) {
        LiquidSettings::declare(o);
        o.number("height", height, "length", above(0), "of the column, uncompressed; --cells go along it");
        o.number("width", width, "length", above(0), "of the column, in whole cells");
        o.number("g", g, "length/time^2", above(0), "gravity");
        o.choice("start", start, {"rest", "sudden"}, "compressed by its weight, or by gravity that acts at once and makes it bounce");
    }
    /// Time in which a wave goes to the bottom and back twice: the period of the bouncing.
    double period() const { return 4 * height / liquid().wave_speed(); }
};

/// Since a particle keeps its mass, the pressure is rho g (H - Y) with its height Y in the uncompressed column, however soft the liquid is.
struct Hydrostatic : HydrostaticSettings {
    static constexpr int D = 2;
    static constexpr const char* name = "hydrostatic";
    static constexpr const char* solves = "a column of liquid at rest under its weight";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 3> columns{"p_bottom", "p_bottom_exact", "speed_max"};
    using Law = Newtonian;

    double h = 1;  // [length]
    std::vector<SymmetryPlane<2>> walls{};

    Hydrostatic() = default;
    Hydrostatic(const HydrostaticSettings& settings, int cells) : HydrostaticSettings(settings), h(settings.height / cells) {
        const Lattice<2> grid = lattice(cells, 1);
        walls = {{grid, 0, 0}, {grid, 0, across() * h}, {grid, 1, 0}};
    }

    Law law() const { return liquid(); }
    /// Twice the pressure of rest comes when gravity acts at once.
    double wave_speed() const { return law().signal_speed(law().wave_speed(2 * weight()), h); }
    double speed() const { return weight() / (rho * law().wave_speed()); }
    double weight() const { return rho * g * height; }
    double exact(double Y) const { return rho * g * (height - Y); }
    /// The same at t. Gravity that acts at once on a stiff liquid sends a linear wave up and down: d'Alembert's solution with the pressure
    /// of rest, even about the bottom and odd about the surface.
    double exact(double Y, double t) const {
        if (start == "rest") return exact(Y);
        const auto wave = [&](double s) { return exact(std::abs(std::remainder(s, 4 * height))); };
        const double ct = law().wave_speed() * t;
        return exact(Y) - (wave(Y + ct) + wave(Y - ct)) / 2;
    }
    Animated animated() const { return {"x", "y", "pressure", "x [length]", "y [length]", column_label("pressure")}; }

    /// Where a particle stands under the weight above it, the integral of J from the bottom.
    double compressed(double Y) const {
        if (start == "sudden") return Y;
        const double s0 = 1 + weight() / kappa, s = 1 + exact(Y) / kappa, power = 1 - 1 / gamma;
        return kappa / (rho * g) * (std::pow(s0, power) - std::pow(s, power)) / power;
    }

    static constexpr int outside = 2;  // cells beyond the walls
    int across() const { return std::max(1, static_cast<int>(std::lround(width / h))); }
    Lattice<2> lattice(int cells, int per_cell) const {
        const double size = height / cells;
        const int wide = std::max(1, static_cast<int>(std::lround(width / size)));
        return {Vec<2>::Constant(-outside * size), Vec<2>::Constant(size), {wide + 2 * outside, cells + 2 * outside + cells / 4}, per_cell};
    }
    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        std::vector<Point> all;
        const double s = h / ppc;
        const Law liquid = law();
        for (int j = 0; j < cells * ppc; ++j)
            for (int i = 0; i < across() * ppc; ++i) {
                Point& p = all.emplace_back();
                p.X = Vec<2>((i + 0.5) * s, (j + 0.5) * s);
                p.x = Vec<2>(p.X[0], compressed(p.X[1]));
                p.V0 = p.V = s * s;
                p.m = rho * p.V0;
                if (start == "sudden") continue;
                p.F(1, 1) = liquid.volume_ratio(exact(p.X[1]));
                liquid.start(p, exact(p.X[1]));
            }
        return all;
    }

    template <class Body> void load(Body& body, double) const { gravity().load(body.grid); }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        for (const auto& wall : walls) wall.apply(grid, field);
    }
    template <class Bodies> Supply supply(const Bodies& bodies, double, double dt) const {
        Supply sum;
        for (const auto* body : bodies) {
            sum += gravity().supply(body->grid, dt);
            for (const auto& wall : walls) {
                const Vec<2> f = wall.held_force(body->grid);
                for (const std::size_t d : {0, 1}) sum.impulse[d] -= dt * f[static_cast<int>(d)];
            }
        }
        return sum;
    }

    /// Mean pressure of the lowest cells' particles, whose middle is h/2 above the bottom; and the largest speed.
    template <class Points> std::array<double, 3> watch(const Points& points, double t) const {
        double p_sum = 0, fastest = 0;
        int count = 0;
        for (const auto& p : points) {
            fastest = std::max(fastest, p.v.norm());
            if (p.X[1] < h) p_sum += p.p, ++count;
        }
        return {p_sum / count, exact(h / 2, t), fastest};
    }

    /// Largest and root mean square difference of pressures at the end, and of the mean over time at the bottom, by rho g H.
    struct Observer {
        const Hydrostatic& scene;
        double worst = 0, square = 0, sum = 0, fastest = 0;
        long steps = 0;

        template <class Points> void sample(const Points& points, double t, double energy) {
            const auto now = scene.watch(points, t);
            if (t > 0) sum += now[0], ++steps;
            fastest = std::max(fastest, now[2]);
            if (std::isnan(energy) || t == 0) return;
            for (const auto& p : points) {
                const double error = std::abs(p.p - scene.exact(p.X[1], t)) / scene.weight();
                worst = std::max(worst, error);
                square += error * error / static_cast<double>(points.size());
            }
        }
        bool wants_energy(double t, double t_end) const { return t >= t_end * (1 - 1e-12); }
        double bottom() const { return sum / static_cast<double>(steps) / scene.exact(scene.h / 2) - 1; }
        std::vector<NamedError> errors(double) const {
            return {{"pressure_max", worst}, {"pressure_rms", std::sqrt(square)}, {"bottom_mean", std::abs(bottom())}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"rho g H", scene.weight()},
                    {"largest pressure error at the end / rho g H", worst},
                    {"its root mean square / rho g H", std::sqrt(square)},
                    {"bottom pressure, mean over time / exact - 1", bottom()},
                    {"largest speed", fastest}};
        }
    };

private:
    Gravity<2> gravity() const { return {Vec<2>(0, -g)}; }
};

}  // namespace mpm
