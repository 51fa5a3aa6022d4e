/// TLMPM, the total-Lagrangian MPM (review 2.6, Algorithm 3; line numbers in the margin): weights and gradients belong to the initial
/// positions and are stored (`Stored<Shape>`), forces come from the first Piola-Kirchhoff stress. No cell crossing, no numerical fracture,
/// but no contact between bodies either. `stress` "musl" is the printed flavour; with "usl" the grid velocities of line 17 stay (USL).
#pragma once
#include <string>

#include "chapters/explicit/musl.hpp"

namespace mpm {

struct Tlmpm {
    static constexpr const char* name = "tlmpm";
    template <int D> using PointOf = Point<D>;
    template <int D> using NodeOf = Musl::NodeOf<D>;
    std::string stress = "musl";  // MUSL flavour, or "usl"

    template <class Bodies, class Coupling, class Scene>
    void step(Bodies& bodies, const Coupling& coupling, const Scene& scene, double t, double dt) const {
        using Body = typename Bodies::value_type;
        using Node = typename Body::Node;
        constexpr int D = Body::D;
        const bool double_mapping = stress == "musl";
        for (auto& body : bodies) {
            body.grid.reset();                                                            // 7
            scatter(body, [&](const auto& p, const auto& weights) {                       // 8
                const Mat<D> V0_P = p.V0 * p.sigma * cofactor(p.F);                       // 27: P = J sigma F^-T
                for (const auto& [node, phi, grad] : weights) {
                    node.m += phi * p.m;                                                  // 3
                    node.mv += phi * p.m * body.transfer.velocity(p, node);               // 9
                    node.f -= V0_P * grad;                                                // 11
                }
            });
            scene.load(body, t);                                                          // 10, 12
            each(body.grid, [&](auto& node) { node.mv_new = node.mv + dt * node.f; });    // 14
            scene.fix(body.grid, &Node::mv, t);                                           // 15
            scene.fix(body.grid, &Node::mv_new, t + dt);
        }
        coupling(bodies, dt);
        for (auto& body : bodies) {
            const auto fix = [&](auto field) { scene.fix(body.grid, field, t + dt); };
            body.transfer.nodal_velocities(body, fix);                                    // 17
            each(body.grid, [&](auto& node) {
                node.v_tilde = node.v_new;
                if (double_mapping) node.mv_new = Vec<D>::Zero();
            });
            scatter(body, [&](auto& p, const auto& weights) {                             // 16
                body.transfer.update_velocity(p, weights);                                // 18
                if (!double_mapping) return;
                for (const auto& [node, phi, grad] : weights)
                    node.mv_new += phi * p.m * body.transfer.velocity(p, node);           // 19
            });
            fix(&Node::mv_new);                                                           // 20
            if (double_mapping) body.transfer.mapped_velocities(body, fix);
            gather(body, [&](auto& p, const auto& weights) {                              // 22
                Vec<D> v = Vec<D>::Zero();
                Mat<D> Fdot = Mat<D>::Zero();
                for (const auto& [node, phi, grad] : weights) {
                    v += phi * node.v_new;
                    Fdot += node.v_new * grad.transpose();                                // 23
                }
                p.F += dt * Fdot;                                                         // 24
                const Mat<D> L = Fdot * p.F.inverse();                                    // 25
                p.V = p.F.determinant() * p.V0;
                body.law.update(p, L, dt);                                                // 26
                p.x += dt * body.transfer.moving(p, v);                                   // 28
            });
            update_together(body);
        }
    }
};

}  // namespace mpm
