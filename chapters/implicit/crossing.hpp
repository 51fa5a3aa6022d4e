/// The flying bar by implicit MPM with one kind of element; each is compiled on its own.
#pragma once
#include <string>

#include "chapters/implicit/program.hpp"
#include "chapters/scenes/free_bar.hpp"

namespace mpm {

struct CrossingSettings {
    FreeBar bar = {};
    ImplicitOptions method = {};
    ImplicitSettings settings = {};
    Common common = {};
};

template <class Element> Assembled fly(const CrossingSettings& s, int cells, const std::string& newton_file) {
    FreeBar bar = s.bar;
    bar.cells = cells, bar.ppc = s.common.ppc;
    const double limit = bar.h(cells) / Element::stride / (bar.wave_speed() + bar.speed());
    bar.dt = whole_steps(s.common.t_end, s.common.dt > 0 ? s.common.dt : s.common.cfl * limit, limit).dt;
    return assemble_implicit<Element>(bar, s.settings, cells, s.common, newton_file);
}

}  // namespace mpm
