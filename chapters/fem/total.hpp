/// Total-Lagrangian explicit finite elements (review F.2, Algorithms 14 and 16; line numbers in the margin): gradients and volumes belong
/// to the initial configuration, forces come from the first Piola-Kirchhoff stress. The TLMPM without its particles: nodes keep their
/// velocities, points are Gauss points.
#pragma once
#include "chapters/fem/node.hpp"

namespace mpm {

struct TotalFem {
    static constexpr const char* name = "fem-total";
    template <int D> using PointOf = Point<D>;
    template <int D> using NodeOf = FemNode<D>;

    template <class Bodies, class Scene> void start(Bodies& bodies, const Scene& scene) const {
        for (auto& body : bodies) start_elements(body, scene);                            // 14: 2-3
    }

    /// The stresses of 16: 11-12 are those that the end of the step before left at the Gauss points.
    template <class Bodies, class Coupling, class Scene>
    void step(Bodies& bodies, const Coupling& coupling, const Scene& scene, double t, double dt) const {
        using Body = typename Bodies::value_type;
        using Node = typename Body::Node;
        constexpr int D = Body::D;
        for (auto& body : bodies) {
            for (auto& node : body.grid) node.f = Vec<D>::Zero();                         // 16: 5
            scatter(body, [&](const auto& p, const auto& weights) {                       // 16: 1, 6
                const Mat<D> V0_P = p.V0 * p.sigma * cofactor(p.F);                       // P = J sigma F^-T, w det J = V0
                for (const auto& [node, phi, grad] : weights) node.f -= V0_P * grad;      // 16: 13, 15
            });
            scene.load(body, t);                                                          // 14: 7
            for (auto& node : body.grid) node.mv_new = node.m * node.v + dt * node.f;     // 14: 10
            scene.fix(body.grid, &Node::mv_new, t + dt);                                  // 14: 11
        }
        coupling(bodies, dt);
        for (auto& body : bodies) {
            for (auto& node : body.grid) {
                node.v = velocity<D>(node.mv_new, node.m);
                node.u += dt * node.v;                                                    // 14: 12
            }
            gather(body, [&](auto& p, const auto& weights) {
                p.x = p.X;
                p.v = Vec<D>::Zero();
                p.F = identity<D>();
                Mat<D> Fdot = Mat<D>::Zero();
                for (const auto& [node, phi, grad] : weights) {
                    p.x += phi * node.u;
                    p.v += phi * node.v;
                    p.F += node.u * grad.transpose();                                     // 16: 11
                    Fdot += node.v * grad.transpose();
                }
                p.V = p.F.determinant() * p.V0;
                const Mat<D> L = Fdot * p.F.inverse();
                body.law.update(p, L, dt);                                                // 16: 12
            });
        }
    }
};

}  // namespace mpm
