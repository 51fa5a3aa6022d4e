#include "chapters/explicit/usf.hpp"

#include "examples/mms_square/updated.hpp"

namespace mpm {

Assembled usf_square(const SquareSettings& s, int cells) { return updated_square(s, Usf{}, cells); }

}  // namespace mpm
