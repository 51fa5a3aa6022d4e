#include "chapters/explicit/tlmpm.hpp"

#include "chapters/improved/variants.hpp"
#include "examples/flying_bar/settings.hpp"

namespace mpm {

Assembled tlmpm_flying(const FlyingSettings& s, int cells) {
    return assemble_named<FlyingShapes, true>(Tlmpm{}, FlyingBar<true>(s.scene, cells), s.transfer, cells, s.common);
}

}  // namespace mpm
