#include "chapters/explicit/musl.hpp"

#include "examples/two_disks/disks.hpp"

namespace mpm {

Assembled musl_disks(const TwoDisksSettings& s, int cells) { return disks<UpdatedShapes, false>(s, Musl{}, cells); }

}  // namespace mpm
