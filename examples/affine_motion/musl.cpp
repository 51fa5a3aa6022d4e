#include "chapters/explicit/musl.hpp"

#include "examples/affine_motion/updated.hpp"

namespace mpm {

Assembled musl_affine(const AffineSettings& s, int cells) { return updated_affine(s, Musl{}, cells); }

}  // namespace mpm
