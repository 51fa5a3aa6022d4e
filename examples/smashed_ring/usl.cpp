#include "chapters/explicit/usl.hpp"

#include "examples/smashed_ring/ring.hpp"

namespace mpm {

Assembled usl_ring(const SmashedRingSettings& s, int cells) { return ring(s, Usl{s.cutoff}, cells); }

}  // namespace mpm
