/// The consistent mass matrix: nodal velocities solve M v = mv with M_IJ = sum m_p phi_I phi_J, the limit of FMPM(k) for k to infinity.
/// Needs more particles than nodes: with one particle per cell M is singular (a checkerboard of nodal velocities that no particle sees).
#pragma once
#include <cmath>
#include <limits>
#include <vector>

#include "chapters/explicit/point.hpp"
#include "lab/body.hpp"
#include "lab/mass_matrix.hpp"

namespace mpm {

/// A velocity component that is held keeps its value and its row leaves the system; nodes without mass stay at rest. The total-Lagrangian
/// matrix is factored once.
template <bool TotalLagrangian> struct Consistent {
    static constexpr const char* name = "consistent";
    template <class Point> using PointOf = Point;
    template <class Base> struct NodeOf : Base {
        Vec<Base::D> probe = Vec<Base::D>::Zero();  // finds out which components are held
    };
    double alpha = 1;  // 1 = FLIP, 0 = PIC [-]

    template <class Point, class Node> const auto& velocity(const Point& p, const Node&) const { return p.v; }

    template <class Body, class Fix> void nodal_velocities(Body& body, Fix&& fix) {
        using Node = typename Body::Node;
        prepare(body, fix);
        solve(body, &Node::mv, &Node::v);
        solve(body, &Node::mv_new, &Node::v_new);
    }
    template <class Body, class Fix> void mapped_velocities(Body& body, Fix&& fix) {
        using Node = typename Body::Node;
        prepare(body, fix);
        solve(body, &Node::mv_new, &Node::v_new);
    }

    template <class Point, class Weights> void update_velocity(Point& p, const Weights& weights) const {
        auto v = p.v;
        v *= alpha;
        for (const auto& [node, phi, grad] : weights) v += phi * (node.v_new - alpha * node.v);
        p.v = v;
    }
    template <class Point, class Velocity> const Velocity& moving(const Point&, const Velocity& v) const { return v; }

private:
    /// Assembles M and factors it for each component.
    template <class Body, class Fix> void prepare(Body& body, Fix&& fix) {
        using Node = typename Body::Node;
        if (TotalLagrangian && !mass_.empty()) return;
        for (auto& node : body.grid) node.probe.setConstant(std::numeric_limits<double>::quiet_NaN());
        fix(&Node::probe);
        held_.assign(Body::D, {});
        for (std::size_t d = 0; d < held_.size(); ++d)
            for (const auto& node : body.grid) held_[d].push_back(!(node.m > 0) || !std::isnan(node.probe[static_cast<int>(d)]));
        entries_.clear();
        const auto* first = &body.grid[0];
        in_order(body, [&](const auto& p, const auto& weights) {
            for (const auto& [a, phi_a, grad_a] : weights)
                for (const auto& [b, phi_b, grad_b] : weights)
                    entries_.push_back({static_cast<int>(&a - first), static_cast<int>(&b - first), p.m * phi_a * phi_b});
        });
        mass_.factor(body.grid.size(), entries_, held_);
    }

    template <class Body, class Momentum, class Velocity> void solve(Body& body, Momentum mv, Velocity v) {
        values_.resize(static_cast<std::size_t>(body.grid.size()));
        for (int d = 0; d < Body::D; ++d) {
            const auto& held = held_[static_cast<std::size_t>(d)];
            for (std::size_t I = 0; I < values_.size(); ++I) {
                const auto& node = body.grid[static_cast<int>(I)];
                values_[I] = held[I] ? mpm::velocity(node.*mv, node.m)[d] : (node.*mv)[d];
            }
            mass_.solve(d, values_);
            for (std::size_t I = 0; I < values_.size(); ++I) (body.grid[static_cast<int>(I)].*v)[d] = values_[I];
        }
    }

    MassMatrix mass_;
    std::vector<MassMatrix::Entry> entries_;
    std::vector<std::vector<bool>> held_;  // for each component
    std::vector<double> values_;
};

}  // namespace mpm
