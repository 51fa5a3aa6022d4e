/// The transfer between particles and grid of review equation 2.53: a mix of FLIP (alpha = 1) and PIC (alpha = 0).
#pragma once
#include "chapters/explicit/point.hpp"

namespace mpm {

/// The seam `transfer`: what a particle gives to a node, how nodal momenta become velocities, how a particle takes them back.
struct Flip {
    static constexpr const char* name = "flip";
    double alpha = 1;  // 1 = FLIP, 0 = PIC [-]

    /// Velocity that particle p brings to a node (2.43).
    template <class Point, class Node> const auto& velocity(const Point& p, const Node&) const { return p.v; }

    /// Nodal velocities at t and t + dt from the momenta, lumped mass (2.40).
    template <class Body> void nodal_velocities(Body& body) const {
        for (auto& node : body.grid) {
            node.v = mpm::velocity(node.mv, node.m);
            node.v_new = mpm::velocity(node.mv_new, node.m);
        }
    }

    /// Particle velocity at t + dt (2.53).
    template <class Point, class Weights> void update_velocity(Point& p, const Weights& weights) const {
        auto v = p.v;
        v *= alpha;
        for (const auto& [node, phi, grad] : weights) v += phi * (node.v_new - alpha * node.v);
        p.v = v;
    }
};

}  // namespace mpm
