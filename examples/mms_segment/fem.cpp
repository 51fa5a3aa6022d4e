#include "chapters/fem/total.hpp"
#include "chapters/fem/updated.hpp"
#include "examples/mms_segment/segment.hpp"

namespace mpm {

Assembled fem_segment(const SegmentSettings& s, int cells) {
    if (s.formulation == "total") return segment<ElementShapes, true>(s, TotalFem{}, NoTransfer{}, cells);
    return segment<ElementShapes, true>(s, UpdatedFem{}, NoTransfer{}, cells);
}

}  // namespace mpm
