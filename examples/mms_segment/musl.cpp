#include "chapters/explicit/musl.hpp"

#include "examples/mms_segment/segment.hpp"

namespace mpm {

Assembled musl_segment(const SegmentSettings& s, int cells) { return segment<UpdatedShapes, false>(s, Musl{}, cells); }

}  // namespace mpm
