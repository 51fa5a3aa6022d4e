/// A bar or a rectangular plate that is heated from its boundary (review 5.3.3, figures 51 and 52), with the exact temperature.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "chapters/material/conductor.hpp"
#include "chapters/scenes/slab_exact.hpp"
#include "lab/clock.hpp"
#include "lab/fill.hpp"
#include "lab/options.hpp"

namespace mpm {

/// What the command line says of the body.
struct HotBodySettings {
    double length = 1, height = 1, k = 1, c = 1, rho = 1, T0 = 0, T1 = 1, flux = 1, film = 1, source = 0;
    std::string which = "held";

    void declare(Options& o, bool plane) {
        o.choice("case", which, {"held", "flux", "convection", "insulated"},
                 plane ? "the boundary: all sides held at T1; flux or convection through the right and the upper side, the others "
                         "insulated; all insulated, with a cosine at the start"
                       : "the ends: left held at T0 and right at T1; flux or convection through the right one, the left insulated; both "
                         "insulated, with a cosine at the start");
        o.number("length", length, "length", above(0), plane ? "width of the plate" : "length of the bar");
        if (plane) o.number("height", height, "length", above(0), "height of the plate");
        o.number("k", k, "power/(length temperature)", above(0), "conductivity");
        o.number("c", c, "energy/(mass temperature)", above(0), "specific heat");
        o.number("rho", rho, plane ? "mass/area" : "mass/length", above(0), "density");
        o.number("T0", T0, "temperature", any(), "temperature at the start");
        o.number("T1", T1, "temperature", any(),
                 "temperature of held boundaries, around (convection), or at the left at the start (insulated)");
        o.number("flux", flux, "power/area", any(), "heat flux into the body; for --case flux");
        o.number("film", film, "power/(area temperature)", above(0), "heat flux per difference to T1; for --case convection");
        o.number("source", source, "power/volume", any(), "heat produced inside; for --case flux and insulated");
    }
    /// Refuses what means nothing. Throws BadInput.
    void check(const Options& o) const {
        const auto only = [&](const char* option, bool allowed, const char* cases) {
            if (o.given(option) && !allowed)
                throw BadInput(std::string("--") + option + ": allowed with --case " + cases + ", not " + which);
        };
        only("flux", which == "flux", "flux");
        only("film", which == "convection", "convection");
        only("source", which == "flux" || which == "insulated", "flux and insulated");
        only("T1", which != "flux", "held, convection and insulated");
        if (which != "flux" && T1 == T0) throw BadInput("--T1: the same as T0 leaves nothing to conduct; any other number is allowed");
        if (which == "flux" && flux == 0) throw BadInput("--flux: 0 heats nothing; any other number is allowed");
    }
};

/// A bar from x = 0 to `length` or a plate with a corner at the origin, on a grid of its own size: it does not move.
template <int Dim> struct HotBody : HotBodySettings {
    static constexpr int D = Dim;
    static constexpr const char* name = D == 1 ? "hot-bar" : "hot-plate";
    static constexpr const char* solves = D == 1 ? "a bar heated at its ends" : "a plate heated from its sides";
    static constexpr const char* reference = "exact";
    static constexpr std::array<const char*, 4> columns{"T_mid", "T_mid_exact", "heat", "heat_in"};
    using Law = Conductor;

    HotBody() = default;
    explicit HotBody(const HotBodySettings& s) : HotBodySettings(s), end_(s.film * s.length / s.k), top_(s.film * s.height / s.k) {}

    Law law() const { return {{k, c, source}, rho}; }
    Vec<D> size() const { return D == 1 ? Vec<D>::Constant(length) : Vec<D>(Vec<2>(length, height).head<D>()); }
    /// Time in which heat crosses the body, L^2/kappa: what --periods counts, though nothing swings.
    double crossing_time() const { return size().maxCoeff() * size().maxCoeff() / law().diffusivity(); }
    double default_t_end() const { return 0.05 * crossing_time(); }  // the review's last time

    Lattice<D> lattice(int cells, int per_cell) const {
        const double h = size().maxCoeff() / cells;
        std::array<int, D> n{};
        Vec<D> cell;
        for (int d = 0; d < D; ++d) {
            n[static_cast<std::size_t>(d)] = std::max(2, static_cast<int>(std::lround(size()[d] / h)));
            cell[d] = size()[d] / n[static_cast<std::size_t>(d)];
        }
        return {Vec<D>::Zero(), cell, n, per_cell};
    }
    template <class Point> std::vector<Point> particles(const Lattice<D>& lattice, int ppc) const {
        std::vector<Point> all;
        const auto add = [&](const Vec<D>& x) {
            Point& p = all.emplace_back();
            p.x = x;
            p.V = lattice.h().prod() / power(ppc, D);
            p.m = rho * p.V;
            p.T = exact(x, 0);
        };
        const Vec<D> part = lattice.h() / ppc;
        for (int j = 0; j < (D == 2 ? lattice.cells(D - 1) * ppc : 1); ++j)
            for (int i = 0; i < lattice.cells(0) * ppc; ++i) add(part.cwiseProduct(Vec<D>(Vec<2>(i + 0.5, j + 0.5).head<D>())));
        return all;
    }

    /// Heat that flows in through the boundary: integrals of phi_I q (5.21), by two Gauss points an edge.
    template <class Body> void heat(Body& body, double) const {
        if (which != "flux" && which != "convection") return;
        const auto flow_in = [&](const Vec<D>& x, double area) {
            const auto stencil = body.shape.at(x, body.points.front());
            double T = 0;
            for (const auto& e : stencil) T += e.phi * body.grid[e.node].T;
            const double q = which == "flux" ? flux : film * (T1 - T);
            for (const auto& e : stencil) body.grid[e.node].Q_ext += e.phi * area * q;
        };
        for (int d = 0; d < D; ++d) each_end_point(body.grid.lattice(), d, flow_in);
    }
    /// Dirichlet nodes.
    template <class Grid, class Field> void hold(Grid& grid, Field field, double) const {
        if (which != "held") return;
        for (int I = 0; I < grid.size(); ++I)
            if (is_held(grid.lattice(), I)) grid[I].*field = D == 1 && I == 0 ? T0 : T1;
    }
    bool is_held(const Lattice<D>& lattice, int I) const {
        if (which != "held") return false;
        for (int d = 0; d < D; ++d)
            if (lattice.along(I, d) == 0 || lattice.along(I, d) == lattice.nodes(d) - 1) return true;
        return false;
    }

    double exact(const Vec<D>& x, double t) const {
        const double kappa = law().diffusivity(), warmed = source * t / (rho * c);
        const auto Fo = [&](int d) { return kappa * t / (size()[d] * size()[d]); };
        double product = 1, sum = 0;
        for (int d = 0; d < D; ++d) {
            const double xi = x[d] / size()[d];
            if (which == "held" && D == 1) return T0 + (T1 - T0) * slab::between_held_ends(xi, Fo(0));
            if (which == "held") product *= slab::held_ends(xi, Fo(d));
            if (which == "convection") product *= (d == 0 ? end_ : top_)(xi, Fo(d));
            if (which == "insulated") product *= slab::insulated(xi, Fo(d));
            if (which == "flux") sum += flux * size()[d] / k * slab::heated_end(xi, Fo(d));
        }
        if (which == "flux") return T0 + sum + warmed;
        return which == "insulated" ? T0 + (T1 - T0) * product + warmed : T1 + (T0 - T1) * product;
    }

    /// Lowest and highest temperature that conduction can make until t_end: heat flows from high to low, so these are at the start or on
    /// the boundary. Insulated: of the cosine, both signs of it.
    std::array<double, 2> range(double t_end) const {
        double low = std::min(T0, which == "flux" ? T0 : T1), high = std::max(T0, which == "flux" ? T0 : T1);
        if (which == "insulated") low -= high - low;
        if (which == "flux")
            for (const Vec<D>& x : {Vec<D>(Vec<D>::Zero()), size()})
                low = std::min(low, exact(x, t_end)), high = std::max(high, exact(x, t_end));
        const double warmed = source * t_end / (rho * c);
        return {low + std::min(0.0, which == "flux" ? 0.0 : warmed), high + std::max(0.0, which == "flux" ? 0.0 : warmed)};
    }
    /// Distance of x to the nearest side that is heated; with --case insulated there is none.
    double depth(const Vec<D>& x) const {
        double nearest = std::numeric_limits<double>::infinity();
        if (which == "insulated") return nearest;
        for (int d = 0; d < D; ++d) {
            nearest = std::min(nearest, size()[d] - x[d]);
            if (which == "held" && D == 2) nearest = std::min(nearest, x[d]);
        }
        return nearest;
    }

private:
    /// Visits the Gauss points of the side at the upper end of axis d: `visit(x, its part of the side)`.
    template <class Visit> void each_end_point(const Lattice<D>& lattice, int d, Visit&& visit) const {
        Vec<D> x = size();
        if constexpr (D == 1) return visit(x, 1.0);
        const int along = (D - 1) - d;
        static const CellRule rule = gauss_points(2);
        for (int cell = 0; cell < lattice.cells(along); ++cell)
            for (std::size_t q = 0; q < rule.at.size(); ++q) {
                x[along] = (cell + rule.at[q]) * lattice.h()[along];
                visit(x, rule.part[q] * lattice.h()[along]);
            }
    }

    slab::ConvectiveEnd end_{1}, top_{1};  // of the axes x, y
};

}  // namespace mpm
