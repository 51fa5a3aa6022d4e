/// Updated-Lagrangian explicit finite elements (review F.1, Algorithms 14 and 15; line numbers in the margin): the mesh moves with its
/// nodes, and gradients, volumes and the Cauchy stress are those of the moved mesh.
#pragma once
#include "chapters/fem/node.hpp"

namespace mpm {

struct UpdatedFem {
    static constexpr const char* name = "fem-updated";
    template <int D> using PointOf = Point<D>;
    template <int Dim> struct NodeOf : FemNode<Dim> {
        Vec<Dim> x = Vec<Dim>::Zero();  // position; the grid tells it where the mesh starts
    };

    template <class Bodies, class Scene> void start(Bodies& bodies, const Scene& scene) const {
        for (auto& body : bodies) start_elements(body, scene);                            // 14: 2-3
    }

    /// Shape function gradients go from the parent domain to the moved mesh with J^-T, J = sum x_I (x) grad N_I. The stresses of 15: 10
    /// are those that the end of the step before left at the Gauss points.
    template <class Bodies, class Coupling, class Scene>
    void step(Bodies& bodies, const Coupling& coupling, const Scene& scene, double t, double dt) const {
        using Body = typename Bodies::value_type;
        using Node = typename Body::Node;
        constexpr int D = Body::D;
        for (auto& body : bodies) {
            for (auto& node : body.grid) node.f = Vec<D>::Zero();                         // 15: 4
            scatter(body, [&](const auto& p, const auto& weights) {                       // 15: 1, 5
                const Mat<D> to_mesh = jacobian<D>(weights).inverse();                    // 15: 7
                for (const auto& [node, phi, grad] : weights)
                    node.f -= p.V * p.sigma * (to_mesh.transpose() * grad);               // 15: 8, 11, 13
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
                node.x += dt * node.v;                                                    // 14: 13
            }
            gather(body, [&](auto& p, const auto& weights) {
                const Mat<D> J = jacobian<D>(weights), to_mesh = J.inverse();             // 15: 7
                p.x = p.v = Vec<D>::Zero();
                Mat<D> L = Mat<D>::Zero(), H = Mat<D>::Zero();
                for (const auto& [node, phi, grad] : weights) {
                    const Vec<D> dNdx = to_mesh.transpose() * grad;                       // 15: 8
                    p.x += phi * node.x;
                    p.v += phi * node.v;
                    L += node.v * dNdx.transpose();
                    H += node.u * dNdx.transpose();
                }
                p.F = (identity<D>() - H).inverse();                                      // (F.5)
                p.V = J.determinant() * p.V0;                                             // w det J
                body.law.update(p, L, dt);                                                // 15: 10
            });
        }
    }

private:
    template <int D, class Weights> static Mat<D> jacobian(const Weights& weights) {
        Mat<D> J = Mat<D>::Zero();
        for (const auto& [node, phi, grad] : weights) J += node.x * grad.transpose();
        return J;
    }
};

}  // namespace mpm
