#include "chapters/explicit/musl.hpp"

#include "examples/mms_square/updated.hpp"

namespace mpm {

Assembled musl_square(const SquareSettings& s, int cells) { return updated_square(s, Musl{}, cells); }

}  // namespace mpm
