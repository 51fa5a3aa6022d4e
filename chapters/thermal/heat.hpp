/// Explicit heat conduction (review 5.3.1, Algorithm 8; line numbers in the margin). As in MUSL, the updated particle temperatures are
/// mapped back, and the flux comes from these nodal temperatures.
///
/// Line 10 is printed to overwrite T at t of a held node, too. Then line 12 gives the particles next to it the change of T* alone, which is
/// zero: the jump at a heated boundary never reaches them, and the particles are of first order. Here T at t stays as it was mapped
/// (`printed` has it both ways).
#pragma once
#include "lab/body.hpp"

namespace mpm {

/// A thermal particle: no velocity, no stress.
template <int Dim> struct HeatPoint {
    static constexpr int D = Dim;
    double m = 0, V = 0;        // mass, volume
    Vec<D> x = Vec<D>::Zero();  // position
    double T = 0;               // temperature
    Vec<D> q = Vec<D>::Zero();  // heat flux [power/area]
};

/// What a node keeps for heat conduction.
struct HeatNode {
    double C = 0, CT = 0, CT_new = 0;      // heat capacity [energy/temperature]; heat at t, at t + dt
    double Q_ext = 0, Q = 0;               // heat flow from outside, all of it [power]
    double T = 0, T_tilde = 0, T_new = 0;  // temperature at t, before and after the second mapping
    void reset() { *this = HeatNode(); }
};

struct Heat {
    static constexpr const char* name = "heat";
    template <int D> using PointOf = HeatPoint<D>;
    template <int> using NodeOf = HeatNode;
    bool printed = false;  // line 10 as printed

    /// A scene tells heat(body, t), which adds to Q_ext what flows in (5.21; the nodes know T), and hold(grid, field, t), which sets T*.
    /// Its law: flux(grad T), source [power/volume] and c.
    template <class Bodies, class Scene> void step(Bodies& bodies, const Scene& scene, double t, double dt) const {
        for (auto& body : bodies) {
            const double c = body.law.c, source = body.law.source;
            each(body.grid, [](auto& node) { node.HeatNode::reset(); });
            scatter(body, [&](const auto& p, const auto& weights) {                       // 2
                for (const auto& [node, phi, grad] : weights) {
                    node.C += phi * p.m * c;                                              // 3
                    node.CT += phi * p.m * c * p.T;                                       // 4
                    node.Q_ext += phi * p.V * source;                                     // 5
                    node.Q += p.V * p.q.dot(grad);                                        // 6
                }
            });
            each(body.grid, [](auto& node) { node.T = temperature(node.CT, node.C); });
            scene.heat(body, t);                                                          // 5
            each(body.grid, [&](auto& node) {
                node.Q += node.Q_ext;                                                     // 7
                node.T_tilde = node.T + dt * temperature(node.Q, node.C);                 // 9
            });
            if (printed) scene.hold(body.grid, &HeatNode::T, t);                          // 10
            scene.hold(body.grid, &HeatNode::T_tilde, t + dt);
            scatter(body, [&](auto& p, const auto& weights) {                             // 11
                for (const auto& [node, phi, grad] : weights) p.T += phi * (node.T_tilde - node.T);  // 12
                for (const auto& [node, phi, grad] : weights) node.CT_new += phi * p.m * c * p.T;  // 13
            });
            map_back(body);                                                               // 13
            scene.hold(body.grid, &HeatNode::T_new, t + dt);                              // 14
            update_flux(body);
        }
    }

    /// The flux at the start, which the review leaves open: of the particles' temperatures alone, since what is held from now on heats
    /// within the first step.
    template <class Bodies> void start(Bodies& bodies) const {
        for (auto& body : bodies) {
            each(body.grid, [](auto& node) { node.HeatNode::reset(); });
            scatter(body, [&](const auto& p, const auto& weights) {
                for (const auto& [node, phi, grad] : weights) {
                    node.C += phi * p.m * body.law.c;
                    node.CT_new += phi * p.m * body.law.c * p.T;
                }
            });
            map_back(body);
            update_flux(body);
        }
    }

private:
    /// CT/C, and zero where no particle is.
    static double temperature(double CT, double C) { return C > 0 ? CT / C : 0; }

    template <class Body> static void map_back(Body& body) {
        each(body.grid, [](auto& node) { node.T_new = temperature(node.CT_new, node.C); });
    }
    template <class Body> static void update_flux(Body& body) {
        gather(body, [&](auto& p, const auto& weights) {
            Vec<Body::D> grad_T = Vec<Body::D>::Zero();
            for (const auto& [node, phi, grad] : weights) grad_T += node.T_new * grad;
            p.q = body.law.flux(grad_T);                                                  // 15
        });
    }
};

}  // namespace mpm
