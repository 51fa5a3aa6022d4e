#include "chapters/explicit/usf.hpp"

#include "examples/mms_segment/segment.hpp"

namespace mpm {

Assembled usf_segment(const SegmentSettings& s, int cells) { return segment<UpdatedShapes, false>(s, Usf{}, cells); }

}  // namespace mpm
