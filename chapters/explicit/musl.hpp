/// MUSL, the double mapping scheme (review 2.5.4, Algorithm 2; line numbers in the margin): the nodal velocities of the stress update are mapped
/// back from the updated particles, so that no force is ever divided by a tiny nodal mass.
#pragma once
#include "chapters/explicit/point.hpp"
#include "lab/body.hpp"

namespace mpm {

struct Musl {
    static constexpr const char* name = "musl";
    template <int D> using PointOf = Point<D>;
    template <int Dim> struct NodeOf : mpm::Node<Dim> {
        Vec<Dim> v_tilde = Vec<Dim>::Zero();  // velocity before the second mapping
        void reset() { *this = NodeOf(); }
        static constexpr auto fields() { return std::tuple_cat(mpm::Node<Dim>::fields(), std::tuple(&NodeOf::v_tilde)); }
    };

    template <class Bodies, class Coupling, class Scene>
    void step(Bodies& bodies, Coupling&& coupling, const Scene& scene, double t, double dt) const {
        using Body = typename Bodies::value_type;
        using Node = typename Body::Node;
        constexpr int D = Body::D;
        for (auto& body : bodies) {
            body.grid.reset();                                                            // 6
            scatter(body, [&](const auto& p, const auto& weights) {                       // 7
                const Mat<D> V_sigma = p.V * p.sigma;
                for (const auto& [node, phi, grad] : weights) {
                    node.m += phi * p.m;                                                  // 8
                    node.mv += phi * p.m * body.transfer.velocity(p, node);               // 9
                    node.f -= V_sigma * grad;                                             // 11
                }
            });
            scene.load(body, t);                                                          // 10, 12
            each(body.grid, [&](auto& node) { node.mv_new = node.mv + dt * node.f; });    // 14
            scene.fix(body.grid, &Node::mv, t);                                           // 15
            scene.fix(body.grid, &Node::mv_new, t + dt);
        }
        coupling(bodies, t, dt);
        for (auto& body : bodies) {
            const auto fix = [&](auto field) { scene.fix(body.grid, field, t + dt); };
            body.transfer.nodal_velocities(body, fix);                                    // 17
            each(body.grid, [&](auto& node) {
                node.v_tilde = node.v_new;
                node.mv_new = Vec<D>::Zero();
            });
            scatter(body, [&](auto& p, const auto& weights) {                             // 16
                body.transfer.update_velocity(p, weights);                                // 19
                for (const auto& [node, phi, grad] : weights)
                    node.mv_new += phi * p.m * body.transfer.velocity(p, node);           // 20
            });
            fix(&Node::mv_new);                                                           // 21
        }
        coupling.again(bodies, t, dt);
        for (auto& body : bodies) {
            const auto fix = [&](auto field) { scene.fix(body.grid, field, t + dt); };
            body.transfer.mapped_velocities(body, fix);                                   // 24
            gather(body, [&](auto& p, const auto& weights) {                              // 23
                Vec<D> v = Vec<D>::Zero();
                Mat<D> L = Mat<D>::Zero();
                for (const auto& [node, phi, grad] : weights) {
                    v += phi * node.v_tilde;
                    L += node.v_new * grad.transpose();                                   // 25
                }
                p.x += dt * body.transfer.moving(p, v);      // 18, here since the weights of 25 are those of x at t
                p.F += dt * L * p.F;                                                      // 26
                p.V = p.F.determinant() * p.V0;                                           // 27
                body.law.update(p, L, dt);                                                // 28
            });
            update_together(body);
            follow(body, dt);
        }
    }
};

}  // namespace mpm
