/// A cantilever that vibrates in its first bending mode, beside Timoshenko's beam.
#pragma once
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "lab/boundary.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"

namespace mpm {

/// What the command line says of the beam, and its theory in plane strain: E' = E/(1 - nu^2), shear factor 5/6.
struct BeamSettings {
    double E = 1000, nu = 0.3, rho = 1, length = 8, height = 1, amplitude = 0.1;

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/area", above(0), "density");
        o.number("length", length, "length", above(0), "length of the beam");
        o.number("height", height, "length", above(0), "height of the beam");
        o.number("amplitude", amplitude, "length", above(0), "displacement of the tip that beam theory gives");
    }
    void check() const {
        if (height > length / 4) throw BadInput("--height = " + std::to_string(height) + ": allowed up to a fourth of --length");
        if (amplitude > length / 4) throw BadInput("--amplitude = " + std::to_string(amplitude) + ": allowed up to a fourth of --length");
    }

    double bending() const { return E / (1 - nu * nu) * height * height * height / 12; }
    /// First angular frequency of the clamped-free beam: the least zero of Timoshenko's characteristic function (Huang 1961), by bisection
    /// between half of Euler and Bernoulli's frequency and a little more than that.
    double omega() const {
        const double unit = std::sqrt(bending() / (rho * height)) / (length * length), slender = first_root() * first_root();
        double low = 0.5 * slender, high = 1.01 * slender;
        for (int i = 0; i < 60; ++i) {
            const double middle = (low + high) / 2;
            (characteristic(middle) > 0 ? low : high) = middle;
        }
        return low * unit;
    }
    double period() const { return 2 * std::numbers::pi / omega(); }

    /// The slender beam's first mode, 1 at the tip, and its slope.
    double mode(double x) const {
        const double k = first_root() * x / length;
        return (std::cosh(k) - std::cos(k) - ratio() * (std::sinh(k) - std::sin(k))) / 2;
    }
    double slope(double x) const {
        const double k = first_root() * x / length;
        return first_root() / length * (std::sinh(k) + std::sin(k) - ratio() * (std::cosh(k) - std::cos(k))) / 2;
    }

private:
    static double first_root() { return 1.8751040687119611; }  // of cosh k cos k + 1
    static double ratio() {
        const double k = first_root();
        return (std::cosh(k) + std::cos(k)) / (std::sinh(k) + std::sin(k));
    }
    /// b = omega L^2 sqrt(rho A/(E' I)).
    double characteristic(double b) const {
        const double G = E / (2 * (1 + nu)), r2 = height * height / 12 / (length * length);
        const double s2 = bending() / (5.0 / 6 * height * G * length * length);
        const double root = std::sqrt((r2 - s2) * (r2 - s2) + 4 / (b * b));
        const double alpha = b * std::sqrt((root - r2 - s2) / 2), beta = b * std::sqrt((root + r2 + s2) / 2);
        return 2 + (b * b * (r2 - s2) * (r2 - s2) + 2) * std::cosh(alpha) * std::cos(beta) -
               b * (r2 + s2) / std::sqrt(1 - b * b * r2 * s2) * std::sinh(alpha) * std::sin(beta);
    }
};

/// The beam lies along x from the clamped end at x = 0, where all nodes are held; its lower side is on a grid line.
struct VibratingBeam : BeamSettings {
    static constexpr int D = 2;
    static constexpr const char* name = "beam";
    static constexpr const char* solves = "a cantilever vibrates in its first bending mode, plane strain";
    static constexpr const char* reference = "beam-theory";
    static constexpr std::array<const char*, 2> columns{"tip", "tip_exact"};
    static constexpr bool may_break = true;  // a bent beam's surface has corners
    using Law = NeoHookean;

    Law law() const { return {E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu)), rho}; }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return amplitude * omega(); }

    Lattice<2> lattice(int cells, int per_cell) const {
        const double h = length / cells;
        const int pad = 3 + static_cast<int>(std::ceil(1.5 * amplitude / h)), across = static_cast<int>(std::ceil(height / h - 1e-9));
        return {Vec<2>(0, -pad * h), Vec<2>::Constant(h), {cells + 3, across + 2 * pad}, per_cell};
    }
    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        const double h = length / cells;
        if (height < 2 * h) throw BadInput("--cells: the beam's height must hold two cells at least");
        const int across = static_cast<int>(std::ceil(height / h - 1e-9));
        const Lattice<2> box(Vec<2>::Zero(), Vec<2>::Constant(h), {cells, across});
        std::vector<Point> all = particles_inside<Point>(Box{Vec<2>::Zero(), Vec<2>(length, height)}, box, middles(ppc), rho);
        for (Point& p : all) {
            p.X = p.x;
            p.v = amplitude * omega() * Vec<2>(-(p.x[1] - height / 2) * slope(p.x[0]), mode(p.x[0]));
        }
        return all;
    }

    template <class Body> void load(Body&, double) const {}
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        for (int I = 0; I < grid.size(); I += grid.lattice().nodes(0)) (grid[I].*field).setZero();
    }
    template <class Grid> Vec<2> held_force(const Grid& grid) const {
        Vec<2> sum = Vec<2>::Zero();
        for (int I = 0; I < grid.size(); I += grid.lattice().nodes(0)) sum += grid[I].f;
        return sum;
    }

    /// Displacement of the tip: the mean of the last column of particles, over the mode's value there.
    template <class Points> double tip(const Points& points) const {
        double last = 0, sum = 0;
        int count = 0;
        for (const auto& p : points) last = std::max(last, p.X[0]);
        for (const auto& p : points)
            if (p.X[0] > last * (1 - 1e-9)) sum += p.x[1] - p.X[1], ++count;
        return sum / count / mode(last);
    }
    double tip_exact(double t) const { return amplitude * std::sin(omega() * t); }
    template <class Points> std::array<double, 2> watch(const Points& points, double t) const { return {tip(points), tip_exact(t)}; }

    struct Observer {
        const VibratingBeam& beam;
        Oscillation wave{};
        double largest = 0;  // displacement of the tip

        template <class Points> void sample(const Points& points, double t, double energy) {
            const double tip = beam.tip(points);
            largest = std::max(largest, std::abs(tip));
            wave.sample(t, tip, beam.tip_exact(t), energy);
        }
        bool wants_energy(double, double) const { return false; }
        std::vector<NamedError> errors(double) const {
            return {{"frequency", std::abs(wave.omega() / beam.omega() - 1)}, {"tip_L2", wave.relative_l2()}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"frequency of beam theory [1/time]", beam.omega() / (2 * std::numbers::pi)},
                    {"frequency / beam theory - 1", wave.omega() / beam.omega() - 1},
                    {"largest displacement of the tip", largest},
                    {"relative L2 error of the tip", wave.relative_l2()}};
        }
    };
};

}  // namespace mpm
