#include "chapters/explicit/usf.hpp"

#include "examples/steel_disk/impact.hpp"

namespace mpm {

Assembled usf_impact(const SteelDiskSettings& s, int cells) { return impact(s, Usf{}, cells); }

}  // namespace mpm
