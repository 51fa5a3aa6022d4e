#include "chapters/explicit/usl.hpp"

#include "chapters/contact/slope/slope.hpp"

namespace mpm {

Assembled usl_slope(const SlopeRun& s, int cells) { return on_slope(s, Usl{}, cells); }

}  // namespace mpm
