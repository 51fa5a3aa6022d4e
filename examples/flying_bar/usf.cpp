#include "chapters/explicit/usf.hpp"

#include "examples/flying_bar/updated.hpp"

namespace mpm {

Assembled usf_flying(const FlyingSettings& s, int cells) { return updated_flying(s, Usf{}, cells); }

}  // namespace mpm
