/// A disk rolls down an incline (Aulisa and Capodaglio, 6.2): x along the plane, y away from it.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "chapters/scenes/graded.hpp"
#include "lab/figure.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/rectilinear.hpp"

namespace mpm {

/// The plane is the lower end of the grid, whose nodes are held: whatever touches the elements there feels it. A rigid disk that rolls goes
/// g t^2 sin(theta)/3. Plane strain and g = 9.81 are not said in the source.
struct RollingDisk {
    static constexpr int D = 2;
    static constexpr const char* name = "rolling-disk";
    static constexpr const char* solves = "an elastic disk rolls down an incline";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 4> columns{"path", "path_exact", "height", "slip"};
    using Law = NeoHookean;

    double E = 4.2e6, nu = 0.4, rho = 1000, R = 1.6, R0 = 1.4, angle = 45, g = 9.81, gap = 0.2, x0 = 1.8;
    int around = 300, layers = 22;

    static Panel path_panel() {
        return {"", "t", "time t [s]", "path of the centre [m]",
                {{"path", "computed", "lines dt solid lc rgb '#c03030'"}, {"path_exact", "rigid disk", "lines dt 2 lc rgb 'black'"}}, ""};
    }
    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/area", above(0), "density");
        o.number("angle", angle, "degrees", between(0, 89), "inclination");
        o.number("g", g, "length/time^2", above(0), "gravity");
        o.number("gap", gap, "length", at_least(0),
                 "gap under the disk at J = 1, halved with every refinement; unless told, 0.2, and 0.3 for E > 4.2e7");
        o.number("x0", x0, "length", between(1.6, 18.4), "start of the centre along the plane of length 20");
        o.integer("around", around, "-", between(12, 100000), "particles on the core's outermost ring");
        o.integer("layers", layers, "-", between(1, 1000), "rings of particles between the core and the surface");
    }
    double mu() const { return E / (2 * (1 + nu)); }
    double lambda() const { return 2 * mu() * nu / (1 - 2 * nu); }
    Law law() const { return {lambda(), mu(), rho}; }
    double wave_speed() const { return law().wave_speed(); }
    double speed() const { return 0; }
    double down() const { return std::sin(angle * std::numbers::pi / 180); }

    /// J, from 20 2^J cells along the plane. Throws BadInput.
    static int refinement(int cells) {
        int J = 0;
        while ((20 << J) < cells && J < 8) ++J;
        if (20 << J != cells) throw BadInput("--cells " + std::to_string(cells) + ": 20, halved J times, is allowed: 20, 40, 80, 160, 320");
        return J;
    }
    /// Four layers, finer towards the plane.
    std::array<Lines, 2> lines(int cells) const {
        const int J = refinement(cells);
        return {halved(even_lines(0, 20, 20), J), halved(Lines{0, 0.85, 0.85 + 1.09, 0.85 + 1.09 + 1.34, 5}, J)};
    }
    std::vector<char> held(const Rectilinear<2>& grid) const {
        std::vector<char> all(static_cast<std::size_t>(grid.size()) * 2, 0);
        std::fill_n(all.begin(), 2 * grid.nodes(0), 1);
        return all;
    }
    Vec<2> body_force(double) const { return g * Vec<2>(down(), -std::sqrt(1 - down() * down())); }
    template <class Point> std::vector<Point> particles(int cells, int) const {
        const Vec<2> centre(x0, R + 2 * gap * std::pow(0.5, refinement(cells)));
        std::vector<Point> all;
        for (const Placed& at : graded_disk(R, R0, around, layers)) {
            Point& p = all.emplace_back();
            p.x = p.X = centre + at.x;
            p.V = p.V0 = at.V;
            p.m = rho * at.V;
        }
        return all;
    }

    double exact(double t) const { return g * t * t * down() / 3; }
    /// Path of the centre, its exact value, height of the centre over R, and 1 - omega R/v: 0 where it rolls, 1 where it slides.
    template <class Points> std::array<double, 4> watch(const Points& points, double t) const {
        double m = 0, J = 0, spin = 0;
        Vec<2> x = Vec<2>::Zero(), v = x;
        for (const auto& p : points) m += p.m, x += p.m * p.x, v += p.m * p.v;
        x /= m, v /= m;
        for (const auto& p : points) {
            const Vec<2> r = p.x - x;
            J += p.m * r.squaredNorm(), spin -= p.m * (r[0] * p.v[1] - r[1] * p.v[0]);
        }
        return {x[0] - x0, exact(t), x[1] - R, t > 0 ? 1 - spin / J * R / v[0] : 0};
    }

    /// (52): the mean over the steps of |x - exact|/exact, and the same with its sign.
    struct Observer {
        const RollingDisk& disk;
        double sum = 0, signed_sum = 0, last = 0, slip = 0;
        long steps = 0;
        template <class Points> void sample(const Points& points, double t, double) {
            if (t == 0) return;
            const auto now = disk.watch(points, t);
            last = now[0] / now[1] - 1, slip = now[3];
            sum += std::abs(last), signed_sum += last, ++steps;
        }
        bool wants_energy(double, double) const { return false; }
        double mean(double total) const { return total / static_cast<double>(steps); }
        std::vector<NamedError> errors(double) const {
            return {{"path", mean(sum)}, {"path_signed", mean(signed_sum)}, {"path_end", std::abs(last)}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"error (52) of the path", mean(sum)},
                    {"the same with its sign", mean(signed_sum)},
                    {"path at the end / exact - 1", last},
                    {"slip, 1 - omega R/v, at the end", slip}};
        }
    };
};

}  // namespace mpm
