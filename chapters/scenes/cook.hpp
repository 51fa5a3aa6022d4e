/// Cook's membrane: a tapered panel of a nearly incompressible solid, held at its left side and sheared at its right one.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "chapters/scenes/pressure_noise.hpp"
#include "lab/boundary.hpp"
#include "lab/figure.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"

namespace mpm {

/// The panel with corners (0, 0), (48, 44), (48, 60), (0, 44).
struct Panel48 {
    bool inside(const Vec<2>& x) const { return x[0] >= 0 && x[0] <= 48 && x[1] >= 44 * x[0] / 48 && x[1] <= 44 + 16 * x[0] / 48; }
    Bounds bounds() const { return {Vec<2>(0, 0), Vec<2>(48, 60)}; }
};

/// What the command line says of the panel.
struct CookSettings {
    double E = 240, nu = 0.4999, rho = 1, force = 10;
    std::string fbar = "moving";
    bool total = false;  // total-Lagrangian: cells are those of the start

    void declare(Options& o) {
        o.choice("fbar", fbar, {"moving", "grid", "off"},
                 "volume changes averaged over the particles that start in a cell, that are in it now (Algorithm 7), or not at all");
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/area", above(0), "density");
        o.number("force", force, "force/length", above(0), "shear force on the right side, which sets in at once");
    }
    double mu() const { return E / (2 * (1 + nu)); }
    double lambda() const { return 2 * mu() * nu / (1 - 2 * nu); }
    double time_to_peak() const { return 320 / std::sqrt(E / rho); }  // about; measured
};

/// `Law` has lambda, mu, rho and average(name). The force acts on the last column of particles.
template <class LawType> struct Cook : CookSettings {
    static constexpr int D = 2;
    static constexpr const char* name = "cook";
    static constexpr const char* solves = "a nearly incompressible tapered panel is sheared at its end";
    static constexpr const char* reference = "none";
    static constexpr bool may_break = true;  // cells that the slanted sides cut may hold no particle
    static constexpr bool numbered = true;   // the loaded particles are known by their numbers
    static constexpr std::array<const char*, 3> columns{"tip", "noise_within", "noise_between"};
    using Law = LawType;

    int cells;

    Cook(const CookSettings& s, int n, int ppc) : CookSettings(s), cells(n) {
        struct Place {
            Vec<2> x;
            double m;
        };
        const Lattice<2> grid = lattice(cells, 1);
        const auto all = particles<Place>(n, ppc);
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all[i].x[0] > 48 - h() / ppc) loaded_.push_back(i);
        for (const int axis : {0, 1}) held_.hold_plane(grid, 0, 0, true, axis);
    }
    double h() const { return 48.0 / cells; }

    Law law() const {
        Law law;
        law.lambda = lambda(), law.mu = mu(), law.rho = rho;
        law.average(fbar);
        return law;
    }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return 0; }

    Lattice<2> lattice(int n, int per_cell) const {
        const double size = 48.0 / n;
        const int up = static_cast<int>(std::ceil(90 / size));
        return {Vec<2>(-3 * size, -3 * size), Vec<2>::Constant(size), {n + 6, up + 3}, per_cell};
    }
    template <class Point> std::vector<Point> particles(int n, int ppc) const {
        return particles_inside<Point>(Panel48{}, lattice(n, 1), middles(ppc), rho);
    }

    template <class Body> void load(Body& body, double) const {
        nodal_.clear();
        for (const std::size_t i : loaded_)
            for (const auto& e : body.shape(body.points[i], i))
                nodal_.emplace_back(e.node, e.phi * force / static_cast<double>(loaded_.size()));
        for (const auto& [I, f] : nodal_) body.grid[I].f[1] += f;
    }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const { held_.apply(grid, field); }
    template <class Bodies> Supply supply(const Bodies& bodies, double, double dt) const {
        Supply sum = held_.supply(bodies[0]->grid, dt);
        for (const auto& [I, f] : nodal_) sum.add(dt * f, 1, bodies[0]->grid[I].v_new[1]);
        return sum;
    }

    /// Upward displacement of the loaded side.
    template <class Points> double tip(const Points& points) const {
        double sum = 0;
        for (const std::size_t i : loaded_) sum += points[i].x[1] - points[i].X[1];
        return sum / static_cast<double>(loaded_.size());
    }
    /// Away from the held side, whose corners let no pressure be smooth.
    template <class Points> PressureNoise noise(const Points& points) const {
        const bool start = total || fbar == "moving";
        return pressure_noise(
            points, h(), 12, 42, [&](const auto& p) { return start ? p.X : p.x; },
            [&](const auto& p) { return volumetric_pressure(p, lambda()); });
    }
    template <class Points> std::array<double, 3> watch(const Points& points, double) const {
        const PressureNoise now = noise(points);
        return {tip(points), now.within, now.between};
    }
    Animated animated() const { return {"x", "y", "pressure", "x [length]", "y [length]", column_label("pressure")}; }

    struct Observer {
        const Cook& scene;
        double peak = 0, t_peak = 0;
        PressureNoise noise{};  // at the peak

        template <class Points> void sample(const Points& points, double t, double) {
            const double tip = scene.tip(points);
            if (!(tip > peak)) return;
            peak = tip, t_peak = t;
            noise = scene.noise(points);
        }
        bool wants_energy(double, double) const { return false; }
        std::vector<NamedError> errors(double) const {
            const double none = std::numeric_limits<double>::quiet_NaN();
            return {{"tip", none}, {"noise_within", noise.within}, {"noise_between", noise.between}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"largest tip displacement", peak},
                    {"at t", t_peak},
                    {"pressure noise within cells", noise.within},
                    {"pressure noise from cell to cell", noise.between}};
        }
    };

private:
    std::vector<std::size_t> loaded_{};                    // numbers of the last column of particles
    mutable std::vector<std::pair<int, double>> nodal_{};  // nodes and the forces that this step put on them
    Dirichlet held_;
};

}  // namespace mpm
