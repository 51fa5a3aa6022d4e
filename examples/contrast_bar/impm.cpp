#include "chapters/improved/impm_assemble.hpp"
#include "examples/contrast_bar/settings.hpp"

namespace mpm {

Assembled impm_contrast(const ContrastSettings& s, int cells) {
    return assemble_impm(ImpmChoice{}, s.scene, s.transfer.alpha, cells, s.common);
}

}  // namespace mpm
