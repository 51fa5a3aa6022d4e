#include "chapters/improved/impm_assemble.hpp"
#include "examples/mms_segment/segment.hpp"

namespace mpm {

Assembled impm_segment(const SegmentSettings& s, int cells) {
    return assemble_impm(s.impm.choice(), s.scene, s.transfer.alpha, cells, s.common);
}

}  // namespace mpm
