#include "chapters/explicit/usl.hpp"

#include "examples/mms_segment/segment.hpp"

namespace mpm {

Assembled usl_segment(const SegmentSettings& s, int cells) { return segment<UpdatedShapes, false>(s, Usl{}, cells); }

}  // namespace mpm
