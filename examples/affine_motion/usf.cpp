#include "chapters/explicit/usf.hpp"

#include "examples/affine_motion/updated.hpp"

namespace mpm {

Assembled usf_affine(const AffineSettings& s, int cells) { return updated_affine(s, Usf{}, cells); }

}  // namespace mpm
