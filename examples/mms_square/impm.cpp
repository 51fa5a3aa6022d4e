#include "chapters/improved/impm_assemble.hpp"
#include "examples/mms_square/settings.hpp"

namespace mpm {

Assembled impm_square(const SquareSettings& s, int cells) {
    return assemble_impm(s.impm.choice(), Square<false>(s.scene), s.transfer.alpha, cells, s.common);
}

}  // namespace mpm
