/// The vibrating bar of review 6.1.1 for implicit MPM: it starts from an eigenvector of the grid's own equations, so that its frequency has
/// a closed form, that of Newmark's rule on the frequency of the grid.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "chapters/implicit/newmark.hpp"
#include "chapters/implicit/residual.hpp"
#include "chapters/scenes/bar.hpp"
#include "lab/rectilinear.hpp"

namespace mpm {

/// Linear elements, equal cells, each with the same points: nodes of a mode move by sin(beta x_I), and the grid's frequency follows from
/// its inner equations. Uniaxial stress of a neo-Hookean bar with lambda = 0, mu = E/2, whose stiffness changes by the strain v0/c, and its
/// frequency by its square.
struct ImplicitBar : Bar<false> {
    using Law = NeoHookean;
    static constexpr std::array<const char*, 4> columns{"v_cm", "v_cm_exact", "v_mode", "v_mode_newmark"};
    int cells = 50, ppc = 1;  // of this resolution
    Newmark newmark = {};
    double dt = 0;  // of whole steps; 0 before it is known

    ImplicitBar() { v0 = 1e-4; }
    Law law() const { return {0, E / 2, rho}; }
    double wave_speed() const { return law().wave_speed(); }

    std::array<Lines, 1> lines(int n) const {
        const Lattice<1> where = lattice(n, 1);
        return {even_lines(0, where.upper()[0], where.cells(0))};
    }
    std::vector<char> held(const Rectilinear<1>& grid) const {
        std::vector<char> all(static_cast<std::size_t>(grid.size()), 0);
        all[0] = 1;
        return all;
    }
    Vec<1> body_force(double) const { return Vec<1>(0); }

    /// v of the points from that of the nodes, v0 sin(beta x_I).
    template <class Point> std::vector<Point> particles(int n, int points) const {
        auto all = Bar<false>::particles<Point>(n, points);
        const double h = cell_size(n);
        for (Point& p : all) {
            const double left = std::floor(p.x[0] / h), s = p.x[0] / h - left;
            p.v[0] = v0 * ((1 - s) * std::sin(beta() * left * h) + s * std::sin(beta() * (left + 1) * h));
        }
        return all;
    }
    /// K = E/h (2 - 2 cos beta h), M = rho h (m_0 + 2 m_1 cos beta h) with m_1 the mean of s (1 - s) over a cell's points, m_0 + 2 m_1 = 1.
    double grid_omega() const {
        const double h = cell_size(cells), theta = beta() * h;
        const CellRule rule = cell_rule(placing, ppc);
        double m1 = 0;
        for (std::size_t q = 0; q < rule.at.size(); ++q) {
            const double s = rule.at[q] + offset;
            m1 += rule.part[q] * (s - std::floor(s)) * (1 - s + std::floor(s));
        }
        return std::sqrt(2 * E / rho * (1 - std::cos(theta)) / (1 - 2 * m1 * (1 - std::cos(theta)))) / h;
    }

    /// Amplitude of the mode among the points: v = v_mode sin(beta x) to h^2.
    template <class Points> double v_mode(const Points& points) const {
        double up = 0, down = 0;
        for (const auto& p : points) {
            const double shape = std::sin(beta() * p.X[0]);
            up += p.m * p.v[0] * shape, down += p.m * shape * shape;
        }
        return up / down;
    }
    double v_mode_newmark(double t) const {
        return dt > 0 ? std::cos(newmark.phase(grid_omega(), dt) * t / dt) : std::numeric_limits<double>::quiet_NaN();
    }
    template <class Points> std::array<double, 4> watch(const Points& points, double t) const {
        return {v_cm(points), v_cm_exact(t), v_mode(points) / v0, v_mode_newmark(t)};
    }

    /// Phase per step of the recurrence v_(n+1) + v_(n-1) = 2 cos(phase) v_n, which every signal of one frequency obeys, by least squares.
    struct Observer {
        const ImplicitBar& bar;
        std::vector<double> v{}, v_cm{}, times{};
        std::vector<double> energies{};  // total, and with the invariant's part

        template <class Points> void sample(const Points& points, double t, double energy) {
            v.push_back(bar.v_mode(points));
            v_cm.push_back(bar.v_cm(points));
            times.push_back(t);
            double a2 = 0;  // E + dt^2 (beta - 1/4) a M a/2 is what Newmark's rule with gamma = 1/2 keeps
            for (const auto& p : points) a2 += p.m * p.a.squaredNorm();
            const double extra = bar.newmark.theta < 1 ? 0 : (bar.newmark.beta - 0.25) * bar.dt * bar.dt * a2 / 2;
            energies.push_back(energy + extra);
        }
        bool wants_energy(double, double) const { return true; }

        double phase() const {
            double up = 0, down = 0;
            for (std::size_t n = 1; n + 1 < v.size(); ++n) up += v[n] * (v[n + 1] + v[n - 1]), down += 2 * v[n] * v[n];
            const double cosine = up / down;
            return std::abs(cosine) <= 1 ? std::acos(cosine) : std::numeric_limits<double>::quiet_NaN();
        }
        double exact_phase() const { return bar.newmark.phase(bar.grid_omega(), bar.dt); }
        double against_newmark() const { return phase() / exact_phase() - 1; }
        double against_exact() const { return phase() / bar.dt / bar.omega() - 1; }
        /// Largest change of the invariant over the run, relative to its start.
        double drift() const {
            double most = 0;
            for (const double e : energies) most = std::max(most, std::abs(e / energies.front() - 1));
            return most;
        }
        /// Largest amplitude error of the mode against cos(phase n).
        double amplitude() const {
            double most = 0;
            const double theta = phase();
            for (std::size_t n = 0; n < v.size(); ++n)
                most = std::max(most, std::abs(v[n] / v[0] - std::cos(theta * static_cast<double>(n))));
            return most;
        }
        double v_cm_L2() const {
            double diff = 0, exact = 0;
            for (std::size_t n = 0; n < v.size(); ++n) {
                const double e = bar.v_cm_exact(times[n]);
                diff += (v_cm[n] - e) * (v_cm[n] - e), exact += e * e;
            }
            return std::sqrt(diff / exact);
        }
        std::vector<NamedError> errors(double) const {
            return {{"frequency", std::abs(against_exact())},
                    {"newmark_frequency", std::abs(against_newmark())},
                    {"invariant", drift()},
                    {"v_cm_L2", v_cm_L2()}};
        }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"frequency / exact - 1", against_exact()},
                    {"frequency / Newmark's - 1", against_newmark()},
                    {"change of the invariant, at most", drift()},
                    {"error of the amplitude, at most", amplitude()}};
        }
    };
};

}  // namespace mpm
