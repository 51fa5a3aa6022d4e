#include "chapters/explicit/usl.hpp"

#include "examples/vortex/updated.hpp"

namespace mpm {

Assembled usl_vortex(const VortexSettings& s, int cells) { return updated_vortex(s, Usl{}, cells); }

}  // namespace mpm
