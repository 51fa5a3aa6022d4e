#include "chapters/explicit/tlmpm.hpp"

#include "chapters/improved/variants.hpp"
#include "examples/contrast_bar/settings.hpp"

namespace mpm {

Assembled tlmpm_contrast(const ContrastSettings& s, int cells) {
    return assemble_named<AllShapes, true>(Tlmpm{}, s.scene.total_lagrangian(), s.transfer, cells, s.common);
}

}  // namespace mpm
