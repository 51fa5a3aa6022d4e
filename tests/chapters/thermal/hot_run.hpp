/// Runs a scene of Algorithm 9 without files.
#pragma once
#include <cmath>
#include <map>
#include <string>

#include "chapters/thermal/assemble_hot.hpp"

namespace mpm::test {

struct Ran {
    std::map<std::string, double> errors;
    Snapshot particles;
};

/// Runs to the scene's t_end.
template <class Scene> Ran ran(const Scene& scene, int cells, double cfl) {
    Common common;
    common.ppc = 2;
    common.t_end = scene.t_end;
    Assembled a = assemble_with<Hat, false>(ThermoMechanics{}, scene, Flip{}, cells, common);
    const long steps = std::lround(std::ceil(scene.t_end / (cfl * a.critical_dt)));
    const double dt = scene.t_end / static_cast<double>(steps);
    for (long i = 0; i < steps; ++i) {
        a.simulation.step(static_cast<double>(i) * dt, dt);
        a.simulation.sample(static_cast<double>(i + 1) * dt, 0);
    }
    Ran r;
    for (const NamedError& e : a.errors(scene.t_end)) r.errors[e.name] = e.value;
    r.particles = a.simulation.particles();
    return r;
}

}  // namespace mpm::test
