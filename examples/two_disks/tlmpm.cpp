#include "chapters/explicit/tlmpm.hpp"

#include "examples/two_disks/disks.hpp"

namespace mpm {

Assembled tlmpm_disks(const TwoDisksSettings& s, int cells) { return disks<AllShapes, true>(s, Tlmpm{}, cells); }

}  // namespace mpm
