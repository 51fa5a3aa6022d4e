/// USF, update stress first (Bardenhagen 2002; review remark 17 and lines 1-13, 27-29 of Algorithm 6 without contact): the stress is updated
/// with the nodal velocities at the start of the step, and its forces move the same step.
#pragma once
#include "chapters/explicit/point.hpp"
#include "lab/body.hpp"

namespace mpm {

struct Usf {
    static constexpr const char* name = "usf";
    template <int D> using PointOf = Point<D>;
    template <int D> using NodeOf = mpm::Node<D>;

    template <class Bodies, class Coupling, class Scene>
    void step(Bodies& bodies, Coupling&& coupling, const Scene& scene, double t, double dt) const {
        using Body = typename Bodies::value_type;
        using Node = typename Body::Node;
        constexpr int D = Body::D;
        for (auto& body : bodies) {
            body.grid.reset();
            scatter(body, [&](const auto& p, const auto& weights) {                       // 2
                for (const auto& [node, phi, grad] : weights) {
                    node.m += phi * p.m;                                                  // 3
                    node.mv += phi * p.m * body.transfer.velocity(p, node);               // 4
                }
            });
            const auto fix = [&](auto field) { scene.fix(body.grid, field, t); };
            fix(&Node::mv);
        }
        coupling.start(bodies, t, dt);
        for (auto& body : bodies) {
            const auto fix = [&](auto field) { scene.fix(body.grid, field, t); };
            each(body.grid, [&](auto& node) { node.mv_new = node.mv; });
            body.transfer.mapped_velocities(body, fix);                                   // 5
            const auto add_forces = [](const auto& p, const auto& weights) {
                const Mat<D> V_sigma = p.V * p.sigma;
                for (const auto& [node, phi, grad] : weights) node.f -= V_sigma * grad;   // 10
            };
            scatter(body, [&](auto& p, const auto& weights) {
                Mat<D> L = Mat<D>::Zero();
                for (const auto& [node, phi, grad] : weights) L += node.v_new * grad.transpose();  // 6
                p.F += dt * L * p.F;                                                      // 7
                p.V = p.F.determinant() * p.V0;                                           // 8
                body.law.update(p, L, dt);                                                // 9
                if constexpr (!updates_together<Body>) add_forces(p, weights);
            });
            if constexpr (updates_together<Body>) {
                update_together(body);
                scatter(body, add_forces);
            }
            scene.load(body, t);                                                          // 11
            each(body.grid, [&](auto& node) { node.mv_new = node.mv + dt * node.f; });    // 13
            scene.fix(body.grid, &Node::mv_new, t + dt);
        }
        coupling(bodies, t, dt);                                                          // 14-26
        for (auto& body : bodies) {
            const auto fix = [&](auto field) { scene.fix(body.grid, field, t + dt); };
            body.transfer.nodal_velocities(body, fix);
            gather(body, [&](auto& p, const auto& weights) {                              // 27
                Vec<D> v = Vec<D>::Zero();
                for (const auto& [node, phi, grad] : weights) v += phi * node.v_new;
                body.transfer.update_velocity(p, weights);                                // 28
                p.x += dt * body.transfer.moving(p, v);                                   // 29
            });
            follow(body, dt);
        }
    }
};

}  // namespace mpm
