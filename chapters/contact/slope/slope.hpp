/// Joins a scheme with the slope.
#pragma once
#include "chapters/contact/bardenhagen.hpp"
#include "chapters/contact/slope_program.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/weighting/assemble_with.hpp"

namespace mpm {

template <class Scheme> Assembled on_slope(const SlopeRun& s, const Scheme& scheme, int cells) {
    const Slope scene(s.slope, s.disk, s.contact.friction(), s.common.t_end, cells);
    return assemble_with<Hat, false>(scheme, scene, Flip{}, cells, s.common, Bardenhagen<2>{s.contact, {}, scene.log});
}

}  // namespace mpm
