/// The smallest run of MUSL: what each file of this folder breaks one piece of.
#pragma once
#include "tests/chapters/explicit/problem.hpp"

namespace mpm::test {

template <class Law, class Scene, class Kernel>
void run(const Scene& scene) {
    Problem<1, Musl, Law, Kernel> problem;
    problem.scheme.step(problem.bodies, Free{}, scene, 0, 0.1);
}

}  // namespace mpm::test
