/// A unit square whose edges are driven so that it deforms homogeneously, as far as one likes: large stretch, compression, shear.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "chapters/material/neo_hookean.hpp"
#include "lab/boundary.hpp"
#include "lab/fill.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"

namespace mpm {

/// x = F X with F = I + t/T (G - I): no particle is accelerated, so that no body force is needed and the stress is the same everywhere.
struct AffineCase {
    double E = 100, nu = 0.3, rho = 1, amount = 2, duration = 10;
    std::string motion = "stretch", placing = "mid";

    void declare(Options& o) {
        o.choice("motion", motion, {"stretch", "compress", "shear"}, "along x, sides held; in both directions alike; simple shear");
        o.number("amount", amount, "-", above(0), "at the end: stretch, det F, or shear");
        o.number("duration", duration, "length/c", above(0), "of the motion, in times in which a P-wave crosses the square");
        o.number("E", E, "stress", above(0), "Young's modulus");
        o.number("nu", nu, "-", {.low = 0, .high = 0.5, .high_open = true}, "Poisson's ratio (plane strain)");
        o.number("rho", rho, "mass/volume", above(0), "density");
        o.choice("points", placing, {"mid", "gauss"}, "particles in the middles of equal parts of a cell, or at Gauss points");
    }
    void check() const {}

    double mu() const { return E / (2 * (1 + nu)); }
    double lambda() const { return 2 * mu() * nu / (1 - 2 * nu); }
    NeoHookean law() const { return {lambda(), mu(), rho}; }
    double T() const { return duration / law().wave_speed(); }

    Mat<2> end() const {  // G
        Mat<2> G = identity<2>();
        if (motion == "stretch") G(0, 0) = amount;
        if (motion == "compress") G *= std::sqrt(amount);
        if (motion == "shear") G(0, 1) = amount;
        return G;
    }
    Mat<2> rate() const { return (end() - identity<2>()) / T(); }
    Mat<2> F(double t) const { return identity<2>() + t * rate(); }
    double speed() const {  // of the fastest corner
        const Mat<2> v = rate();
        return std::max({v.col(0).norm(), v.col(1).norm(), (v.col(0) + v.col(1)).norm()});
    }

    /// The fastest wave from start to end. A plane wave along n in the deformed body has rho c^2 <= mu n.FF^T n + lambda (1 - ln J) + mu;
    /// on the initial one, along N, rho c^2 <= mu + (lambda (1 - ln J) + mu) N.F^-1 F^-T N.
    double wave_speed(bool total_lagrangian) const {
        double fastest = 0;
        for (const double t : {0.0, T()}) {
            const Mat<2> b = F(t) * F(t).transpose();
            const double J = F(t).determinant(), half = b.trace() / 2, large = half + std::sqrt(std::max(0.0, half * half - J * J));
            const double bulk = lambda() * (1 - std::log(std::min(J, 1.0))) + mu(), small = J * J / large;
            fastest = std::max(fastest, total_lagrangian ? mu() + bulk / small : mu() * large + bulk);
        }
        return std::sqrt(fastest / rho);
    }
};

/// Nodes whose cells reach past the square have the velocity of the motion: the others are free, and at rest among themselves if the scheme
/// finds the same stress everywhere. `reach` is that of the weighting functions [cells]. Grid nodes of an updated-Lagrangian step move with
/// the material from where they are at its start, without acceleration: at t + dt they have the velocity of that place at t.
template <bool TotalLagrangian> struct Affine : AffineCase {
    static constexpr int D = 2;
    static constexpr const char* name = "affine";
    static constexpr const char* solves = "a square is deformed homogeneously, as far as one likes, plane strain";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 2> columns{"J_min", "J_max"};
    using Law = NeoHookean;

    int reach = 1;
    std::shared_ptr<double> start = std::make_shared<double>(0);  // of the step

    Affine(const AffineCase& options, int cells_of_reach) : AffineCase(options), reach(cells_of_reach) {}

    double wave_speed() const { return AffineCase::wave_speed(TotalLagrangian); }
    Lattice<2> lattice(int cells, int per_cell) const {
        const double h = 1.0 / cells;
        if (TotalLagrangian) return {Vec<2>::Zero(), Vec<2>::Constant(h), {cells, cells}, per_cell};
        const Vec<2> far = (end() * Vec<2>::Ones()).cwiseMax(Vec<2>::Ones());
        std::array<int, 2> across{};
        for (const std::size_t d : {0, 1}) {
            const double n = std::ceil(far[static_cast<int>(d)] / h - 1e-9);
            if (!(n < 1e4)) throw BadInput("--amount: the grid would have more than 1e4 cells along an axis");
            across[d] = static_cast<int>(n) + 2 * pad;
        }
        return {Vec<2>::Constant(-pad * h), Vec<2>::Constant(h), across, per_cell};
    }
    static constexpr int pad = 3;
    template <class Point> std::vector<Point> particles(int cells, int ppc) const {
        const Lattice<2> square{Vec<2>::Zero(), Vec<2>::Constant(1.0 / cells), {cells, cells}};
        std::vector<Point> all;
        each_point({Vec<2>::Zero(), Vec<2>::Ones()}, square, cell_rule(placing, ppc), [&](const Vec<2>& X, const Bounds& box) {
            Point& p = all.emplace_back();
            p.X = p.x = X;
            p.V = p.V0 = (box.high - box.low).prod();
            p.m = rho * p.V;
            p.v = rate() * X;
        });
        return all;
    }

    template <class Body> void load(Body&, double) const {}
    template <class Grid, class Field> void fix(Grid& grid, Field field, double t) const {
        using Node = typename Grid::Node;
        if (field == static_cast<Field>(&Node::mv)) *start = t;
        each_driven(grid.lattice(), [&](int I, const Vec<2>& v) { grid[I].*field = grid[I].m * v; });
    }
    template <class Bodies> Supply supply(const Bodies& bodies, double, double dt) const {
        Supply sum;
        for (const auto* body : bodies)
            each_driven(body->grid.lattice(), [&](int I, const Vec<2>& v) {
                for (const int d : {0, 1}) sum.add(held_impulse(body->grid[I], d, v[d], dt), d, v[d]);
            });
        return sum;
    }

    template <class Points> std::array<double, 2> watch(const Points& points, double) const {
        double least = 1e300, most = 0;
        for (const auto& p : points) least = std::min(least, p.V / p.V0), most = std::max(most, p.V / p.V0);
        return {least, most};
    }

    struct Strained {
        static constexpr int D = 2;
        Mat<2> F, sigma = Mat<2>::Zero();
    };
    /// At the last step, relative to the exact values: stress and deformation gradient, root mean squares over particles; positions in
    /// parts of the square's side.
    struct Observer {
        const Affine& square;
        double stress = 0, gradient = 0, position = 0;

        template <class Points> void sample(const Points& points, double t, double) {
            if (t < square.T() * (1 - 1e-9) && t > 0) return;
            Strained exact{square.F(t)};
            square.law().update(exact, exact.F, 0);
            double s2 = 0, F2 = 0, x2 = 0;
            for (const auto& p : points) {
                s2 += (p.sigma - exact.sigma).squaredNorm();
                F2 += (p.F - exact.F).squaredNorm();
                x2 += (p.x - exact.F * p.X).squaredNorm();
            }
            const double n = static_cast<double>(points.size());
            stress = std::sqrt(s2 / n / std::max(1e-300, exact.sigma.squaredNorm()));
            gradient = std::sqrt(F2 / n / exact.F.squaredNorm()), position = std::sqrt(x2 / n);
        }
        bool wants_energy(double, double) const { return false; }
        std::vector<NamedError> errors(double) const { return {{"stress", stress}, {"gradient", gradient}, {"position", position}}; }
        std::vector<std::pair<std::string, double>> facts(double) const {
            return {{"stress, rms error / exact", stress},
                    {"deformation gradient, the same", gradient},
                    {"position, rms error / side", position}};
        }
    };

private:
    template <class Visit> void each_driven(const Lattice<2>& lattice, Visit&& visit) const {
        const Mat<2> back = TotalLagrangian ? identity<2>() : Mat<2>(F(*start).inverse());
        const Mat<2> velocity = rate() * back;
        for (int I = 0; I < lattice.size(); ++I) {
            const Vec<2> x = lattice.position(I);
            if (!surrounded(back, x, lattice.h()[0])) visit(I, velocity * x);
        }
    }
    /// Whether the corners of all cells that feel the node lie in the square.
    bool surrounded(const Mat<2>& back, const Vec<2>& x, double h) const {
        const double r = TotalLagrangian ? 0.5 * h : reach * h, most = 1e-9;
        for (const double a : {-r, r})
            for (const double b : {-r, r}) {
                const Vec<2> X = back * (x + Vec<2>(a, b));
                if (X.minCoeff() < -most || X.maxCoeff() > 1 + most) return false;
            }
        return true;
    }
};

}  // namespace mpm
