/// What contact has done so far: a scene shows it, a coupling writes it. Any consistent units.
#pragma once
#include <limits>

#include "lab/math.hpp"

namespace mpm {

template <int D> struct ContactLog {
    double friction = 0, normal = 0;                                  // energy that sliding took, that normal impulses took
    double touched = std::numeric_limits<double>::quiet_NaN();        // when an impulse was first exchanged [time]
    double parted = std::numeric_limits<double>::quiet_NaN();         // when one was last exchanged [time]
    double pressed = 0, rubbed = 0;                                   // impulses over all so far: normal, along the faces
    Vec<D> made = Vec<D>::Zero();                                     // momentum that came out of nothing
    double in_play = 0;                                               // sum of all impulses' sizes
    Vec<D> wall_impulse = Vec<D>::Zero();                             // of walls on bodies, since the last `supply`
    double wall_work = 0;                                             // the same
    long nodes = 0, steps = 0;                                        // shared nodes over all steps; steps that had some
    long without_normal = 0;                                          // pairs left alone, for no normal could be told
};

}  // namespace mpm
