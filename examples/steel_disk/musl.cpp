#include "chapters/explicit/musl.hpp"

#include "examples/steel_disk/impact.hpp"

namespace mpm {

Assembled musl_impact(const SteelDiskSettings& s, int cells) { return impact(s, Musl{}, cells); }

}  // namespace mpm
