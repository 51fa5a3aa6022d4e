/// The transfer between particles and grid of review equation 2.53: a mix of FLIP (alpha = 1) and PIC (alpha = 0).
#pragma once
#include "chapters/explicit/point.hpp"

namespace mpm {

/// The seam `transfer`: what a particle gives to a node, how nodal momenta become velocities, how a particle takes them back. A transfer extends the
/// scheme's point and node by what it needs. `fix` holds the velocities of a momentum field, e.g. fix(&Node::mv_new).
struct Flip {
    static constexpr const char* name = "flip";
    template <class Point> using PointOf = Point;
    template <class Node> using NodeOf = Node;
    double alpha = 1;  // 1 = FLIP, 0 = PIC [-]

    /// Velocity that particle p brings to a node (2.43).
    template <class Point, class Node> const auto& velocity(const Point& p, const Node&) const { return p.v; }

    /// Nodal velocities at t and t + dt from the momenta, lumped mass (2.40).
    template <class Body, class Fix> void nodal_velocities(Body& body, Fix&&) const {
        each(body.grid, [&](auto& node) {
            node.v = mpm::velocity(node.mv, node.m);
            node.v_new = mpm::velocity(node.mv_new, node.m);
        });
    }
    /// Nodal velocities at t + dt alone, after a second mapping.
    template <class Body, class Fix> void mapped_velocities(Body& body, Fix&&) const {
        each(body.grid, [&](auto& node) { node.v_new = mpm::velocity(node.mv_new, node.m); });
    }

    /// Particle velocity at t + dt (2.53).
    template <class Point, class Weights> void update_velocity(Point& p, const Weights& weights) const {
        auto v = p.v;
        v *= alpha;
        for (const auto& [node, phi, grad] : weights) v += phi * (node.v_new - alpha * node.v);
        p.v = v;
    }

    /// Velocity that moves a particle where the grid moves with v.
    template <class Point, class Velocity> const Velocity& moving(const Point&, const Velocity& v) const { return v; }
};

}  // namespace mpm
