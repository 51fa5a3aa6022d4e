#include "chapters/improved/impm_assemble.hpp"
#include "examples/affine_motion/settings.hpp"

namespace mpm {

Assembled impm_affine(const AffineSettings& s, int cells) {
    return assemble_impm(ImpmChoice{}, Affine<false>(s.scene, 1), s.transfer.alpha, cells, s.common);
}

}  // namespace mpm
