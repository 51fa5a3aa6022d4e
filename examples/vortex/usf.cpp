#include "chapters/explicit/usf.hpp"

#include "examples/vortex/updated.hpp"

namespace mpm {

Assembled usf_vortex(const VortexSettings& s, int cells) { return updated_vortex(s, Usf{}, cells); }

}  // namespace mpm
