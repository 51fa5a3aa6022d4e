/// USL, update stress last: the standard explicit MPM (review 2.5.3, Algorithm 1; line numbers in the margin). Velocities of nodes with a
/// tiny mass may be huge (figure 10); the mass cut-off (2.63) sets them to zero and loses their momentum.
#pragma once
#include "chapters/explicit/point.hpp"
#include "lab/body.hpp"

namespace mpm {

struct Usl {
    static constexpr const char* name = "usl";
    template <int D> using PointOf = Point<D>;
    template <int D> using NodeOf = mpm::Node<D>;
    double cutoff = 0;  // nodes with at most this mass are left out (2.63) [mass]

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
            each(body.grid, [&](auto& node) {
                node.mv_new = node.mv + dt * node.f;                                      // 14
                if (node.m <= cutoff) node.mv = node.mv_new = Vec<D>::Zero();             // (2.63)
            });
            scene.fix(body.grid, &Node::mv, t);                                           // 15
            scene.fix(body.grid, &Node::mv_new, t + dt);
        }
        coupling(bodies, t, dt);
        for (auto& body : bodies) {
            const auto fix = [&](auto field) { scene.fix(body.grid, field, t + dt); };
            body.transfer.nodal_velocities(body, fix);                                    // 17
            gather(body, [&](auto& p, const auto& weights) {                              // 16
                Vec<D> v = Vec<D>::Zero();
                Mat<D> L = Mat<D>::Zero();
                for (const auto& [node, phi, grad] : weights) {
                    v += phi * node.v_new;
                    L += node.v_new * grad.transpose();                                   // 20
                }
                body.transfer.update_velocity(p, weights);                                // 18
                p.x += dt * body.transfer.moving(p, v);                                   // 19
                p.F += dt * L * p.F;                                                      // 21
                p.V = p.F.determinant() * p.V0;                                           // 22
                body.law.update(p, L, dt);                                                // 23-25
            });
            update_together(body);
            follow(body, dt);
        }
    }
};

}  // namespace mpm
