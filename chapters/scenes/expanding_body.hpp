/// A solid that expands as it is heated: a bar between clamps (stress -E alpha dT) and a free plate (strain alpha dT, no stress).
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/conductor.hpp"
#include "chapters/material/thermo_elastic.hpp"
#include "chapters/scenes/slab_exact.hpp"
#include "lab/grid.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"

namespace mpm {

/// What the command line says of the body.
struct ExpandingSettings {
    double E = 100, nu = 0.3, rho = 1, expansion = 1e-5, k = 0.01, c = 1, length = 1, dT = 10;
    bool plane = false;
    std::string heating = "end", start = "moving";

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        if (plane) o.number("nu", nu, "-", {.low = -1, .high = 0.5, .low_open = true, .high_open = true}, "Poisson's ratio");
        o.number("rho", rho, plane ? "mass/area" : "mass/length", above(0), "density");
        o.number("expansion", expansion, "1/temperature", any(), "linear thermal expansion");
        o.number("k", k, "power/(length temperature)", above(0), "conductivity");
        o.number("c", c, "energy/(mass temperature)", above(0), "specific heat");
        o.number("length", length, "length", above(0), plane ? "side of the plate" : "length of the bar");
        o.number("dT", dT, "temperature", any(), "rise of temperature: of all until t-end, or of the held end at once");
        if (plane)
            o.choice("start", start, {"moving", "rest"}, "with the velocity of the expansion, or at rest: waves that stay");
        else
            o.choice("heating", heating, {"end", "uniform"}, "the right end held hot from t = 0 and the left cold, or a source everywhere");
    }
};

/// A bar in [0, L], its ends clamped, or a plate about the origin that nothing holds.
template <int Dim> struct ExpandingBody : ExpandingSettings {
    static constexpr int D = Dim;
    static constexpr const char* name = D == 1 ? "clamped-hot-bar" : "free-hot-plate";
    static constexpr const char* solves = D == 1 ? "a bar between clamps is heated" : "a free plate is heated evenly";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 4> columns{"stress", "stress_exact", "eps", "eps_exact"};
    using Law = Conducting<ThermoElastic>;

    double t_end;  // until which a uniform source heats by dT

    ExpandingBody(const ExpandingSettings& s, double until) : ExpandingSettings(s), t_end(until) {}

    bool uniform() const { return D == 2 || heating == "uniform"; }
    Law law() const {
        Law law;
        const double ratio = D == 1 ? 0 : nu;  // the bar is free across: lambda + 2 mu = E
        law.lambda = E * ratio / ((1 + ratio) * (1 - 2 * ratio));
        law.mu = E / (2 * (1 + ratio));
        law.rho = rho;
        law.alpha = expansion;
        law.k = k, law.c = c;
        law.source = uniform() ? rho * c * dT / t_end : 0;
        return law;
    }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return 0; }
    double rate() const { return D == 2 && start == "moving" ? expansion * dT / t_end : 0; }  // of strain at the start

    Lattice<D> lattice(int cells, int per_cell) const {
        const double h = length / cells;
        if constexpr (D == 1)
            return {Vec<1>(0.0), Vec<1>(h), {cells}, per_cell};
        else
            return {Vec<2>::Constant(-length / 2 - 2 * h), Vec<2>::Constant(h), {cells + 4, cells + 4}, per_cell};
    }
    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        std::vector<Point> all;
        const int n = cells * ppc;
        const double part = length / n;
        for (int j = 0; j < (D == 2 ? n : 1); ++j)
            for (int i = 0; i < n; ++i) {
                Point& p = all.emplace_back();
                p.x[0] = (i + 0.5) * part;
                if constexpr (D == 2) p.x = Vec<2>(i + 0.5, j + 0.5) * part - Vec<2>::Constant(length / 2);
                p.X = p.x;
                p.V = p.V0 = std::pow(part, D);
                p.m = rho * p.V;
                p.v = rate() * p.x;
            }
        return all;
    }

    template <class Body> void load(Body&, double) const {}
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        if constexpr (D == 1) (grid[0].*field)[0] = (grid[grid.size() - 1].*field)[0] = 0;
    }
    template <class Grid> Vec<D> held_force(const Grid& grid) const {
        if constexpr (D == 1)
            return grid[0].f + grid[grid.size() - 1].f;
        else
            return Vec<D>::Zero();
    }
    template <class Body> void heat(Body&, double) const {}
    template <class Grid, class Field> void hold(Grid& grid, Field field, double) const {
        if (!uniform()) grid[0].*field = 0, grid[grid.size() - 1].*field = dT;
    }

    /// Mean rise of temperature (5.27) where the bar's ends are held.
    double mean_rise(double t) const {
        if (uniform()) return dT * t / t_end;
        return dT * slab::between_held_ends_mean(law().diffusivity() * t / (length * length));
    }
    double unit_stress() const { return E * expansion * dT; }
    double stress_exact(double t) const { return D == 1 ? -E * expansion * mean_rise(t) : 0; }
    double strain_exact(double t) const { return D == 1 ? 0 : expansion * mean_rise(t); }

    /// Mean stress and logarithmic strain along the axes.
    template <class Points> std::array<double, 2> means(const Points& points) const {
        double stress = 0, strain = 0, V = 0;
        for (const auto& p : points) stress += p.V * p.sigma.trace() / D, strain += p.V * std::log(p.V / p.V0) / D, V += p.V;
        return {stress / V, strain / V};
    }
    template <class Points> std::array<double, 4> watch(const Points& points, double t) const {
        const auto [stress, strain] = means(points);
        return {stress, stress_exact(t), strain, strain_exact(t)};
    }

    struct Observer {
        const ExpandingBody& scene;
        double stress = 0, strain = 0, t = 0, largest = 0;  // now; the largest difference of a particle's stress
        double worst = 0;                                   // of the mean stress, over the second half of the run

        template <class Points> void sample(const Points& points, double now, double) {
            t = now;
            if (t < scene.t_end / 2) return;
            const auto means = scene.means(points);
            stress = means[0], strain = means[1];
            worst = std::max(worst, std::abs(stress - scene.stress_exact(t)));
            largest = 0;
            for (const auto& p : points)
                largest = std::max(largest, (p.sigma - scene.stress_exact(t) * identity<D>()).cwiseAbs().maxCoeff());
        }
        bool wants_energy(double, double) const { return false; }
        std::vector<NamedError> errors(double) const {
            const double unit = std::abs(scene.unit_stress());
            std::vector<NamedError> all{{"stress", std::abs(stress - scene.stress_exact(t)) / unit},
                                        {"stress_max", largest / unit},
                                        {"stress_ripple", worst / unit}};
            if (D == 2) all.insert(all.begin(), {"strain", std::abs(strain / scene.strain_exact(t) - 1)});
            return all;
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            std::vector<std::pair<std::string, double>> all{{"mean stress / (E alpha dT)", stress / scene.unit_stress()},
                                                            {"the same, exact", scene.stress_exact(t) / scene.unit_stress()}};
            if (D == 2) all.emplace_back("strain / (alpha dT) - 1", strain / scene.strain_exact(t) - 1);
            for (const NamedError& e : errors(t)) all.emplace_back("error, " + e.name, e.value);
            return all;
        }
    };
};

}  // namespace mpm
