/// Joins the improved MPM with a scene.
#pragma once
#include "chapters/explicit/flip.hpp"
#include "chapters/improved/impm.hpp"
#include "chapters/weighting/assemble_with.hpp"

namespace mpm {

/// One resolution with hat functions, as the iMPM has them, and FLIP; its report tells what the run has counted.
template <class Scene>
Assembled assemble_impm(const ImpmChoice& choice, const Scene& scene, double alpha, int cells, const Common& common) {
    const Impm<Scene::D> scheme{choice};
    Assembled a = assemble_with<Hat, false>(scheme, scene, Flip{alpha}, cells, common);
    a.facts = [facts = a.facts, seen = scheme.seen](double t_end) {
        auto all = facts(t_end);
        for (const auto& fact : seen->facts()) all.push_back(fact);
        return all;
    };
    return a;
}

}  // namespace mpm
