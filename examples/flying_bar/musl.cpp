#include "chapters/explicit/musl.hpp"

#include "examples/flying_bar/updated.hpp"

namespace mpm {

Assembled musl_flying(const FlyingSettings& s, int cells) { return updated_flying(s, Musl{}, cells); }

}  // namespace mpm
