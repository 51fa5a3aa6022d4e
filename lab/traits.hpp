/// What the common options depend on, read off a scene.
#pragma once
#include "lab/columns.hpp"
#include "lab/figure.hpp"
#include "lab/program.hpp"

namespace mpm {

/// What pictures of particles show: what the scene says or, in 2D, the von Mises stress.
template <class Scene> Animated animated_of(const Scene& scene) {
    if constexpr (requires { scene.animated(); }) return scene.animated();
    else if constexpr (Scene::D == 2) return {"x", "y", "mises", "x [length]", "y [length]", column_label("mises")};
    else return {};
}

/// A scene with a period() has one; in 2D pictures of particles have colours.
template <class Scene> SceneTraits traits_of(const Scene& scene) {
    SceneTraits traits;
    traits.period = requires { scene.period(); };
    traits.colours = colours<Scene::D, typename Scene::Law>();
    if (Scene::D == 2) traits.colour = animated_of(scene).colour;
    return traits;
}

}  // namespace mpm
