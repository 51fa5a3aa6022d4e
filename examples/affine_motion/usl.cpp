#include "chapters/explicit/usl.hpp"

#include "examples/affine_motion/updated.hpp"

namespace mpm {

Assembled usl_affine(const AffineSettings& s, int cells) { return updated_affine(s, Usl{}, cells); }

}  // namespace mpm
