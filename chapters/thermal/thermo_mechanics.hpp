/// Coupled thermo-mechanics (review 5.3.2, Algorithm 9): heat conduction and MUSL on one grid with one time step. Its thermal lines 14-20,
/// 23, 25, 31-33, 42 are Algorithm 8 on the positions at t, and read nothing that the mechanical ones write; these are Algorithm 2, whose
/// stress update (line 41) reads the new temperature. So one step is one of each.
#pragma once
#include "chapters/explicit/musl.hpp"
#include "chapters/thermal/heat.hpp"

namespace mpm {

/// A material point with a temperature.
template <int Dim> struct HotPoint : Point<Dim> {
    double T = 0;                   // temperature
    Vec<Dim> q = Vec<Dim>::Zero();  // heat flux [power/area]
};

struct ThermoMechanics {
    static constexpr const char* name = "thermo-mechanics";
    template <int D> using PointOf = HotPoint<D>;
    template <int D> struct NodeOf : Musl::NodeOf<D>, HeatNode {
        void reset() { Musl::NodeOf<D>::reset(); }  // heat has its own
    };
    Heat heat{};
    Musl musl{};

    /// The scene is one of both: load, fix and heat, hold.
    template <class Bodies, class Coupling, class Scene>
    void step(Bodies& bodies, const Coupling& coupling, const Scene& scene, double t, double dt) const {
        heat.step(bodies, scene, t, dt);
        musl.step(bodies, coupling, scene, t, dt);
    }
    template <class Bodies, class Scene> void start(Bodies& bodies, const Scene&) const { heat.start(bodies); }
};

}  // namespace mpm
