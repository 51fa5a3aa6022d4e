#include "chapters/explicit/tlmpm.hpp"

#include "chapters/explicit/flip.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "examples/cantilever/settings.hpp"

namespace mpm {

Assembled tlmpm_cantilever(const CantileverSettings& s, int cells) {
    Assembled a;
    ShapeList<Hat, Cubic>::with(s.common.shape,
                                [&](auto kernel) { a = assemble_with<decltype(kernel), true>(Tlmpm{}, s.beam, Flip{}, cells, s.common); });
    return a;
}

}  // namespace mpm
