/// What the command line of mms_segment says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/improved/impm_choice.hpp"
#include "chapters/improved/transfers.hpp"
#include "chapters/mms/segment.hpp"
#include "lab/program.hpp"

namespace mpm {

struct SegmentSettings {
    Common common;
    Segment<false> scene;
    TransferChoice transfer;
    ImpmOptions impm;
    std::string scheme = "tlmpm", formulation = "total", stress = "musl";
};

Assembled usl_segment(const SegmentSettings& settings, int cells);
Assembled usf_segment(const SegmentSettings& settings, int cells);
Assembled musl_segment(const SegmentSettings& settings, int cells);
Assembled tlmpm_segment(const SegmentSettings& settings, int cells);
Assembled impm_segment(const SegmentSettings& settings, int cells);
Assembled fem_segment(const SegmentSettings& settings, int cells);

}  // namespace mpm
