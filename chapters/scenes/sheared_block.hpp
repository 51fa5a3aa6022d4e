/// A block of a yielding metal in simple shear so fast that no heat leaves it (review B.13): its temperature from the plastic work.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/conductor.hpp"
#include "chapters/material/plastic_heating.hpp"
#include "chapters/material/von_mises.hpp"
#include "lab/boundary.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"

namespace mpm {

/// What the command line says of the block.
struct ShearSettings {
    double E = 200e9, nu = 0.3, rho = 7850, yield = 400e6, H = 500e6, c = 450, k = 50, chi = 0.9, length = 1e-3, gamma = 1, rate = 1e4;

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = -1, .high = 0.5, .low_open = true, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/volume", above(0), "density");
        o.number("yield", yield, "stress", above(0), "stress in tension at which it yields");
        o.number("H", H, "stress", at_least(0), "hardening: growth of the yield stress with the plastic strain");
        o.number("c", c, "energy/(mass temperature)", above(0), "specific heat");
        o.number("k", k, "power/(length temperature)", above(0), "conductivity");
        o.number("chi", chi, "-", {.low = 0, .high = 1, .low_open = true}, "part of the plastic work that becomes heat");
        o.number("length", length, "length", above(0), "side of the block");
        o.number("rate", rate, "1/time", above(0), "rate of shear");
    }
};

/// Every node moves with the shear, v = (rate y, 0), so that the block deforms evenly; what holds the nodes does the work.
struct ShearedBlock : ShearSettings {
    static constexpr int D = 2;
    static constexpr const char* name = "sheared-block";
    static constexpr const char* solves = "a block yields in fast simple shear and heats up";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 4> columns{"T_mean", "T_mean_exact", "work", "energies"};
    using Law = PlasticHeating<Conducting<VonMises>>;

    double t_end;

    ShearedBlock(const ShearSettings& s, double until) : ShearSettings(s), t_end(until) { gamma = rate * until; }

    double mu() const { return E / (2 * (1 + nu)); }
    Law law() const {
        Law law;
        law.lambda = 2 * mu() * nu / (1 - 2 * nu), law.mu = mu(), law.rho = rho, law.yield = yield, law.H = H;
        law.c = c, law.k = k, law.chi = chi;
        return law;
    }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return rate * length; }

    Lattice<2> lattice(int cells, int per_cell) const {
        const double h = length / cells, room = std::ceil(gamma * cells);
        if (!(room < 1e5))
            throw BadInput("--t-end, --rate: the block is sheared over " + std::to_string(room) + " cells, at most 1e5 are allowed");
        return {Vec<2>::Constant(-2 * h), Vec<2>::Constant(h), {cells + 4 + static_cast<int>(room), cells + 4}, per_cell};
    }
    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        std::vector<Point> all;
        const int n = cells * ppc;
        const double part = length / n;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                Point& p = all.emplace_back();
                p.X = p.x = Vec<2>(i + 0.5, j + 0.5) * part;
                p.V = p.V0 = part * part;
                p.m = rho * p.V;
                p.v = velocity(p.x);
            }
        return all;
    }
    Vec<2> velocity(const Vec<2>& x) const { return {rate * x[1], 0}; }

    template <class Body> void load(Body&, double) const {}
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        for (int I = 0; I < grid.size(); ++I) grid[I].*field = grid[I].m * velocity(grid.lattice().position(I));
    }
    template <class Bodies> Supply supply(const Bodies& bodies, double, double dt) const {
        Supply sum;
        for (const auto* body : bodies)
            for (int I = 0; I < body->grid.size(); ++I) {
                const Vec<2> v = velocity(body->grid.lattice().position(I));
                for (const int axis : {0, 1}) sum.add(held_impulse(body->grid[I], axis, v[axis], dt), axis, v[axis]);
            }
        return sum;
    }
    template <class Body> void heat(Body&, double) const {}
    template <class Grid, class Field> void hold(Grid&, Field, double) const {}

    /// Plastic work per volume, Y e + H e^2/2, of the plastic strain e that belongs to the shear t rate = sqrt(3) e + (Y + H e)/(sqrt(3)
    /// mu): exact but for the square of the elastic shear.
    double plastic_work_exact(double t) const {
        const double elastic = yield / (std::sqrt(3.0) * mu());
        if (rate * t <= elastic) return 0;
        const double e = (rate * t - elastic) / (std::sqrt(3.0) + H / (std::sqrt(3.0) * mu()));
        return yield * e + H * e * e / 2;
    }
    double T_exact(double t) const { return chi * plastic_work_exact(t) / (rho * c); }
    /// Work on the block, heat and elastic energy of pure shear, per volume.
    double work_exact(double t) const {
        const double elastic = yield / (std::sqrt(3.0) * mu());
        if (rate * t <= elastic) return mu() * rate * t * rate * t / 2;
        const double e = (rate * t - elastic) / (std::sqrt(3.0) + H / (std::sqrt(3.0) * mu())), tau = (yield + H * e) / std::sqrt(3.0);
        return plastic_work_exact(t) + tau * tau / (2 * mu());
    }

    template <class Points> double T_mean(const Points& points) const {
        double T = 0, m = 0;
        for (const auto& p : points) T += p.m * p.T, m += p.m;
        return T / m;
    }
    /// Plastic work and elastic energy of the block.
    template <class Points> double energies(const Points& points) const {
        double sum = 0;
        const Law of_all = law();
        for (const auto& p : points) sum += of_all.dissipated(p) + of_all.energy(p);
        return sum;
    }
    template <class Points> std::array<double, 4> watch(const Points& points, double t) const {
        return {T_mean(points), T_exact(t), work_exact(t) * length * length, energies(points)};
    }

    struct Observer {
        const ShearedBlock& scene;
        double T = 0, t = 0, energies = 0, heat = 0, plastic = 0;

        template <class Points> void sample(const Points& points, double now, double) {
            t = now;
            if (t < scene.t_end * (1 - 1e-9)) return;
            T = scene.T_mean(points), energies = scene.energies(points);
            for (const auto& p : points) heat += p.m * scene.c * p.T, plastic += p.plastic_work;
        }
        bool wants_energy(double, double) const { return false; }
        double work() const { return scene.work_exact(t) * scene.length * scene.length; }
        std::vector<NamedError> errors(double) const {
            return {{"temperature", std::abs(T / scene.T_exact(t) - 1)},
                    {"work", std::abs(energies / work() - 1)},
                    {"heat", std::abs(heat / (scene.chi * plastic) - 1)}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"rise of temperature", T},
                    {"the same / exact - 1", T / scene.T_exact(t) - 1},
                    {"plastic and elastic energy / work - 1", energies / work() - 1},
                    {"heat / (chi plastic work) - 1", heat / (scene.chi * plastic) - 1}};
        }
    };
};

}  // namespace mpm
