#include "chapters/explicit/usf.hpp"

#include "examples/smashed_ring/ring.hpp"

namespace mpm {

Assembled usf_ring(const SmashedRingSettings& s, int cells) { return ring(s, Usf{}, cells); }

}  // namespace mpm
