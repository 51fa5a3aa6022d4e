#include "chapters/explicit/usl.hpp"

#include "chapters/improved/variants.hpp"
#include "examples/contrast_bar/settings.hpp"

namespace mpm {

Assembled usl_contrast(const ContrastSettings& s, int cells) {
    return assemble_named<UpdatedShapes, false>(Usl{}, s.scene, s.transfer, cells, s.common);
}

}  // namespace mpm
