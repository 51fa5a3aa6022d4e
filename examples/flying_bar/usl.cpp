#include "chapters/explicit/usl.hpp"

#include "examples/flying_bar/updated.hpp"

namespace mpm {

Assembled usl_flying(const FlyingSettings& s, int cells) { return updated_flying(s, Usl{}, cells); }

}  // namespace mpm
