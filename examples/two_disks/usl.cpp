#include "chapters/explicit/usl.hpp"

#include "examples/two_disks/disks.hpp"

namespace mpm {

Assembled usl_disks(const TwoDisksSettings& s, int cells) { return disks<UpdatedShapes, false>(s, Usl{s.cutoff}, cells); }

}  // namespace mpm
