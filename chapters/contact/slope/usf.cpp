#include "chapters/explicit/usf.hpp"

#include "chapters/contact/slope/slope.hpp"

namespace mpm {

Assembled usf_slope(const SlopeRun& s, int cells) { return on_slope(s, Usf{}, cells); }

}  // namespace mpm
