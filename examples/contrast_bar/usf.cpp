#include "chapters/explicit/usf.hpp"

#include "chapters/improved/variants.hpp"
#include "examples/contrast_bar/settings.hpp"

namespace mpm {

Assembled usf_contrast(const ContrastSettings& s, int cells) {
    return assemble_named<UpdatedShapes, false>(Usf{}, s.scene, s.transfer, cells, s.common);
}

}  // namespace mpm
