/// What velocity_projection does with one weighting function and one transfer: particles of a linear velocity field give it to the grid and
/// take it back, by the transfer's own functions. Particles and nodes are compared with the field.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "chapters/explicit/flip.hpp"
#include "chapters/improved/consistent.hpp"
#include "chapters/improved/mls.hpp"
#include "chapters/weighting/shapes.hpp"
#include "chapters/weighting/tensor.hpp"
#include "lab/body.hpp"
#include "lab/fill.hpp"
#include "lab/options.hpp"
#include "lab/study.hpp"

namespace mpm::projection {

struct Settings : Study {
    double length = 6, offset = 0, jitter = 0;  // of the body; shift of all particles [cells], random shift of each [spacing]
    int cells = 12, ppc = 2, pad = 0, order = 2;
    std::string shape = "all", transfer = "all";
    double h() const { return length / cells; }
};

/// The field v(x) = x of review figure 55; its gradient is 1/time.
inline double field(double x) { return x; }

/// Linear moving least squares at the nodes (mls.hpp; the projection of iMPM, 5.39), with the support 2 h of review D.2. A node that sees
/// fewer than two particles has no line through them: its velocity is not a number.
struct Mls : Flip {
    static constexpr const char* name = "mls";

    template <class Body, class Fix> void nodal_velocities(Body& body, Fix&&) const {
        const MlsChoice choice{1, 2};
        NearPoints<1> near;
        near.fill(body.grid.lattice(), body.points);
        for (int I = 0; I < body.grid.size(); ++I) {
            const auto fit = mls_at<1>(choice, near, body.points, body.grid.lattice().position(I), [](const auto& p) { return p.v; });
            const double v = fit.degree == 1 ? fit.values[0] : std::numeric_limits<double>::quiet_NaN();
            body.grid[I].v[0] = body.grid[I].v_new[0] = v;
        }
    }
};

/// Largest errors in the middle half of the body and in the rest, in h: the difference between the velocities of neighbouring nodes is 1.
struct Errors {
    double middle = 0, ends = 0;
    void see(double x, double v, const Settings& set) {
        double& worst = std::abs(x - set.length / 2) <= 0.2501 * set.length ? middle : ends;
        const double error = std::abs(v - field(x)) / set.h();
        if (!(error <= worst) && !std::isnan(worst)) worst = error;  // what is not a number stays
    }
};

struct Projected {
    std::string shape, transfer;
    std::vector<double> node_x, node_v, particle_x, particle_v;  // of the nodes with mass
    Errors nodes, particles;
    std::string verdict = "ok";
};

/// Places in cells from the lower end of the body; the random numbers are the same in every run. Throws BadInput if a particle may leave
/// the body.
inline std::vector<double> places(const Settings& set) {
    const double room = 0.5 / set.ppc;  // of each particle to both sides
    if (std::abs(set.offset) + set.jitter * room > room * (1 + 1e-12))
        throw BadInput("--offset = " + std::to_string(set.offset) + ": allowed with this --ppc and --jitter up to " +
                       std::to_string((1 - set.jitter) * room));
    const CellRule rule = middles(set.ppc);
    std::vector<double> all;
    std::uint32_t random = 1;
    for (int cell = 0; cell < set.cells; ++cell)
        for (const double at : rule.at) {
            random = 1664525u * random + 1013904223u;  // Knuth and Lewis
            all.push_back(cell + at + set.offset + set.jitter * room * (random / 2147483648.0 - 1));
        }
    return all;
}

/// Fills in the errors. A projection that has no answer has nan for one.
inline void judge(Projected& p, const Settings& set) {
    const auto nan = std::numeric_limits<double>::quiet_NaN();
    if (p.transfer == Consistent<false>::name && p.node_x.size() > p.particle_x.size()) {
        p.verdict = "singular: " + std::to_string(p.node_x.size()) + " nodes, " + std::to_string(p.particle_x.size()) + " particles";
        std::fill(p.node_v.begin(), p.node_v.end(), nan);
        std::fill(p.particle_v.begin(), p.particle_v.end(), nan);
    }
    for (std::size_t i = 0; i < p.node_x.size(); ++i) p.nodes.see(p.node_x[i], p.node_v[i], set);
    for (std::size_t i = 0; i < p.particle_x.size(); ++i) p.particles.see(p.particle_x[i], p.particle_v[i], set);
    if (p.transfer == Mls::name && std::isnan(p.nodes.middle + p.nodes.ends)) p.verdict = "singular: a node sees fewer than two particles";
}

struct NoLaw {};

template <class Kernel, class Transfer> Projected project(const Settings& set, const Transfer& transfer) {
    using Point = typename Transfer::template PointOf<mpm::Point<1>>;
    using Node = typename Transfer::template NodeOf<mpm::Node<1>>;
    using Shape = Tensor<1, Kernel>;
    const Lattice<1> lattice{Vec<1>(-set.pad * set.h()), Vec<1>(set.h()), {set.cells + 2 * set.pad}, Kernel::per_cell};
    Body<1, Point, Node, NoLaw, Shape, Transfer> body{{{}, Grid<1, Node>(lattice), {}}, {lattice, sized<Kernel>(set.ppc)}, transfer};
    for (const double at : places(set)) {
        Point& p = body.points.emplace_back();
        p.X[0] = p.x[0] = at * set.h();
        p.V = p.V0 = p.m = set.h() / set.ppc;
        p.v[0] = field(p.x[0]);
        if constexpr (requires { p.C; }) p.C(0, 0) = 1;  // affine transfers carry the gradient too
    }
    scatter(body, [&](const auto& p, const auto& weights) {
        for (const auto& [node, phi, grad] : weights) {
            node.m += phi * p.m;
            node.mv += phi * p.m * body.transfer.velocity(p, node);
        }
    });
    for (auto& node : body.grid) node.mv_new = node.mv;  // no forces
    body.transfer.nodal_velocities(body, [](auto) {});
    gather(body, [&](auto& p, const auto& weights) { body.transfer.update_velocity(p, weights); });

    Projected result;
    result.shape = Kernel::name;
    result.transfer = transfer.name;
    for (int I = 0; I < body.grid.size(); ++I) {
        if (!(body.grid[I].m > 0)) continue;
        result.node_x.push_back(lattice.position(I)[0]);
        result.node_v.push_back(body.grid[I].v_new[0]);
    }
    for (const Point& p : body.points) {
        result.particle_x.push_back(p.x[0]);
        result.particle_v.push_back(p.v[0]);
    }
    judge(result, set);
    return result;
}

}  // namespace mpm::projection
