/// What total- and updated-Lagrangian finite elements share (review appendix F): nodes that keep their state from step to step. A body's
/// points are the Gauss points, with rho w det J as mass and w det J as volume; its grid is the mesh in the initial configuration, which
/// is also the parent domain of the elements; the shape functions at the Gauss points are stored (`Stored<Tensor<D, Kernel>>`).
#pragma once
#include "chapters/explicit/point.hpp"
#include "lab/body.hpp"

namespace mpm {

template <int Dim> struct FemNode {
    static constexpr int D = Dim;
    double m = 0;                                                       // lumped mass
    Vec<D> u = Vec<D>::Zero(), v = Vec<D>::Zero();                      // displacement, velocity (half a step before it: leapfrog)
    Vec<D> mv_new = Vec<D>::Zero(), f = Vec<D>::Zero();                 // momentum at the end of the step, force
    /// The energy that the leapfrog keeps; velocities interpolated to Gauss points miss a part of it, 1 - cos(beta h) over 3 in mode beta.
    double kinetic() const { return 0.5 * m * v.squaredNorm(); }
};

/// Finite elements have nothing to carry between particles and grid.
struct NoTransfer {
    static constexpr const char* name = "none";
    template <class Point> using PointOf = Point;
    template <class Node> using NodeOf = Node;
};

/// Algorithm 14, lines 2 and 3: masses lumped by row sum, m_I = sum_J int rho N_I N_J = int rho N_I, and velocities of the nodes.
template <class Body, class Scene> void start_elements(Body& body, const Scene& scene) {
    constexpr int D = Body::D;
    scatter(body, [](const auto& p, const auto& weights) {
        for (const auto& [node, phi, grad] : weights) node.m += phi * p.m;
    });
    for (int I = 0; I < body.grid.size(); ++I) {
        auto& node = body.grid[I];
        node.mv_new = node.m * scene.initial_velocity(body.grid.lattice().position(I));
    }
    scene.fix(body.grid, &Body::Node::mv_new, 0);
    for (auto& node : body.grid) node.v = velocity<D>(node.mv_new, node.m);
    gather(body, [](auto& p, const auto& weights) {
        p.v = Vec<D>::Zero();
        for (const auto& [node, phi, grad] : weights) p.v += phi * node.v;
    });
}

}  // namespace mpm
