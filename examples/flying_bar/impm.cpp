#include "chapters/improved/impm_assemble.hpp"
#include "examples/flying_bar/settings.hpp"

namespace mpm {

Assembled impm_flying(const FlyingSettings& s, int cells) {
    return assemble_impm(ImpmChoice{}, FlyingBar<false>(s.scene, cells), s.transfer.alpha, cells, s.common);
}

}  // namespace mpm
