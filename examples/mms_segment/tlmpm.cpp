#include "chapters/explicit/tlmpm.hpp"

#include "examples/mms_segment/segment.hpp"

namespace mpm {

Assembled tlmpm_segment(const SegmentSettings& s, int cells) { return segment<AllShapes, true>(s, Tlmpm{s.stress}, cells); }

}  // namespace mpm
