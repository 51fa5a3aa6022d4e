#include "chapters/explicit/musl.hpp"

#include "chapters/contact/slope/slope.hpp"

namespace mpm {

Assembled musl_slope(const SlopeRun& s, int cells) { return on_slope(s, Musl{}, cells); }

}  // namespace mpm
