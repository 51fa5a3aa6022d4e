#include "chapters/explicit/usl.hpp"

#include "examples/steel_disk/impact.hpp"

namespace mpm {

Assembled usl_impact(const SteelDiskSettings& s, int cells) { return impact(s, Usl{s.cutoff}, cells); }

}  // namespace mpm
