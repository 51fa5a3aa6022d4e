#include "chapters/explicit/musl.hpp"

#include "examples/smashed_ring/ring.hpp"

namespace mpm {

Assembled musl_ring(const SmashedRingSettings& s, int cells) { return ring(s, Musl{}, cells); }

}  // namespace mpm
