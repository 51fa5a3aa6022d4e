#include "chapters/explicit/musl.hpp"

#include "chapters/improved/variants.hpp"
#include "examples/contrast_bar/settings.hpp"

namespace mpm {

Assembled musl_contrast(const ContrastSettings& s, int cells) {
    return assemble_named<UpdatedShapes, false>(Musl{}, s.scene, s.transfer, cells, s.common);
}

}  // namespace mpm
