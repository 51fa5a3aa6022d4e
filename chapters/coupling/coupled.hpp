/// What the programs of MPM with finite elements share.
#pragma once
#include "chapters/implicit/program.hpp"

namespace mpm {

/// As implicit MPM's, without the ways to carry velocities that map them to a grid of particles alone. Throws BadInput.
inline ImplicitSettings coupled_settings(const ImplicitOptions& method, const Options& options, int threads) {
    const ImplicitSettings s = method.settings(options, threads);
    if (s.carry == Carry::lumped || s.carry == Carry::projected || s.carry == Carry::increment)
        throw BadInput("--carry " + method.carry + ": with finite elements particle, midpoint and conserving are allowed");
    return s;
}

}  // namespace mpm
