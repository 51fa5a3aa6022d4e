#include "chapters/explicit/usf.hpp"

#include "examples/two_disks/disks.hpp"

namespace mpm {

Assembled usf_disks(const TwoDisksSettings& s, int cells) { return disks<UpdatedShapes, false>(s, Usf{}, cells); }

}  // namespace mpm
