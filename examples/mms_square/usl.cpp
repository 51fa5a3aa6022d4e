#include "chapters/explicit/usl.hpp"

#include "examples/mms_square/updated.hpp"

namespace mpm {

Assembled usl_square(const SquareSettings& s, int cells) { return updated_square(s, Usl{}, cells); }

}  // namespace mpm
