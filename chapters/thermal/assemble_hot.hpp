/// Joins Algorithm 9 with a scene, and runs it: what its programs share.
#pragma once
#include <algorithm>
#include <string>

#include "chapters/explicit/flip.hpp"
#include "chapters/thermal/thermo_mechanics.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "lab/traits.hpp"

namespace mpm {

using HotShapes = ShapeList<Hat, Cubic>;

/// One resolution: waves and conduction both limit the step.
template <class Scene> Assembled assemble_hot(const Scene& scene, int cells, const Common& common) {
    constexpr int D = Scene::D;
    Assembled a;
    HotShapes::with(common.shape,
                    [&](auto kernel) { a = assemble_with<decltype(kernel), false>(ThermoMechanics{}, scene, Flip{}, cells, common); });
    const double conduction = conduction_step<D>(scene.lattice(cells, 1).h(), scene.law().diffusivity());
    a.critical_dt = std::min(a.critical_dt, conduction);
    a.simulation.critical_dt = [waves = a.simulation.critical_dt, conduction] { return std::min(waves(), conduction); };
    return a;
}

/// The body of a program. `settings` declares the scene's options, `make` makes the scene of them and of the common ones.
template <class Scene, class Settings> int hot_program(const std::string& program, const std::string& purpose, Settings settings,
                                                       Common common, double t_end, const std::vector<Panel>& panels, int argc,
                                                       char** argv) {
    return guarded(program, [&] {
        Options options(program, purpose);
        settings.declare(options);
        SceneTraits traits = traits_of(Scene(settings, t_end));
        traits.limit = "h/(c + |v|) or, if smaller, the conduction's step";
        common.declare(options, HotShapes::names(), t_end, traits);
        options.parse(argc, argv);
        if (answered(options, program)) return 0;
        const Scene scene(settings, common.t_end);
        const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, 0, panels};
        return run_program(about, options, common, [&](int cells) { return assemble_hot(scene, cells, common); });
    });
}

}  // namespace mpm
