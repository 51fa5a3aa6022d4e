#include "chapters/explicit/musl.hpp"

#include "examples/vortex/updated.hpp"

namespace mpm {

Assembled musl_vortex(const VortexSettings& s, int cells) { return updated_vortex(s, Musl{}, cells); }

}  // namespace mpm
