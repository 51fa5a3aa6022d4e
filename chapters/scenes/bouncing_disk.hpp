/// A disk falls on an elastic plate and bounces (Aulisa and Capodaglio, 6.3): what is the same for finite elements and particles in the
/// plate.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"

namespace mpm {

/// Plate 0 < x < 1.28, -0.16 < y < 0 (two layers of 0.08; 0.64 is printed too), its lower face held, its ends free; gravity acts on the
/// disk alone. Plane strain, g = 9.81, and how the plate is held are not said in the source.
struct BouncingDisk {
    static constexpr int D = 2;
    static constexpr const char* solves = "an elastic disk falls on an elastic plate and bounces";
    static constexpr const char* reference = "none";
    static constexpr std::array<const char*, 5> columns{"height", "height_rigid", "potential", "pressing", "sinking"};
    static constexpr double width = 1.28, plate_height = 0.16, above_plate = 1.84;

    double E = 5.91e6, E_plate = 4.2e7, nu = 0.4, rho = 1000, R = 0.16, g = 9.81, drop = 1.52;

    void declare(Options& o) {
        o.number("E", E, "stress", above(0), "Young's modulus of the disk");
        o.number("E-plate", E_plate, "stress", above(0), "Young's modulus of the plate");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio of both (plane strain)");
        o.number("rho", rho, "mass/area", above(0), "density of both");
        o.number("g", g, "length/time^2", above(0), "gravity, on the disk alone");
        o.number("drop", drop, "length", between(0.02, 1.52), "distance of disk and plate at the start");
    }
    NeoHookean law_of(double modulus) const {
        const double mu = modulus / (2 * (1 + nu));
        return {2 * mu * nu / (1 - 2 * nu), mu, rho};
    }
    double wave_speed() const { return std::max(law_of(E).wave_speed(), law_of(E_plate).wave_speed()); }
    double speed() const { return std::sqrt(2 * g * drop); }
    double falls() const { return std::sqrt(2 * drop / g); }
    Vec<2> centre() const { return {width / 2, R + drop}; }
    /// J, from 8 2^J cells along the plate. Throws BadInput.
    static int refinement(int cells) {
        int J = 0;
        while ((8 << J) < cells && J < 8) ++J;
        if (8 << J != cells) throw BadInput("--cells " + std::to_string(cells) + ": 8, doubled J times, is allowed: 16, 32, 64, 128");
        return J;
    }
    /// Height of a rigid disk that loses nothing, bouncing at once.
    double height_rigid(double t) const {
        const double since = std::fmod(t + falls(), 2 * falls()) - falls();
        return drop - g * since * since / 2;
    }

    /// Mass, height of the centre above that of touching, velocity.
    struct State {
        double m = 0, height = 0, v = 0, lowest = std::numeric_limits<double>::infinity();
        template <class Point> void add(const Point& p) {
            m += p.m, height += p.m * p.x[1], v += p.m * p.v[1];
            lowest = std::min(lowest, p.x[1]);
        }
        void close(double R) { height = height / m - R, v /= m; }
    };

    /// The turning points of the centre, and the energy there, that of the height included, over m g times the first height.
    struct Bounces {
        struct Apex {
            double t, height, energy;
        };
        std::vector<Apex> all{};
        double t = 0, v = 0, height = 0, weight = 0, lowest = std::numeric_limits<double>::infinity();

        void add(const State& now, double time, double energy, double g) {
            if (time == 0) weight = now.m * g, all.push_back({0, now.height, energy + weight * now.height});
            lowest = std::min(lowest, now.height);
            if (time > 0 && v > 0 && now.v <= 0) {  // velocities are nearly linear in flight
                const double part = v / (v - now.v);
                all.push_back({t + part * (time - t), height + 0.5 * v * part * (time - t), energy + weight * now.height});
            }
            t = time, v = now.v, height = now.height;
        }
        double rebound(std::size_t k) const {
            return k < all.size() ? all[k].height / all[0].height : std::numeric_limits<double>::quiet_NaN();
        }
        std::vector<NamedError> errors() const {
            std::vector<NamedError> e;
            for (std::size_t k = 1; k <= 5; ++k) e.push_back({"rebound_lost_" + std::to_string(k), 1 - rebound(k)});
            return e;
        }
        std::vector<std::pair<std::string, double>> facts() const {
            std::vector<std::pair<std::string, double>> f;
            for (std::size_t k = 1; k < all.size() && k <= 5; ++k) {
                const std::string number = std::to_string(k);
                f.emplace_back("rebound " + number + " at", all[k].t);
                f.emplace_back("its height / the first", rebound(k));
                f.emplace_back("energy / the first", all[k].energy / all[0].energy);
            }
            f.emplace_back("lowest height of the centre - R", lowest);
            return f;
        }
    };
};

/// What a run of either scene notes.
template <class Scene> struct BounceObserver {
    const Scene& scene;
    BouncingDisk::Bounces bounces{};
    template <class Points> void sample(const Points& points, double t, double energy) { bounces.add(scene.state(points), t, energy, scene.g); }
    bool wants_energy(double, double) const { return true; }
    std::vector<NamedError> errors(double) const { return bounces.errors(); }
    std::vector<std::pair<std::string, double>> facts(double) const { return bounces.facts(); }
};

}  // namespace mpm
