#include "chapters/explicit/tlmpm.hpp"

#include "chapters/explicit/flip.hpp"
#include "chapters/locking/fbar_cantilever/settings.hpp"
#include "chapters/weighting/assemble_with.hpp"

namespace mpm {

Assembled tlmpm_cantilever(const FbarCantileverSettings& s, int cells) {
    Assembled a;
    ShapeList<Hat, Cubic>::with(s.common.shape, [&](auto kernel) {
        a = assemble_with<decltype(kernel), true>(Tlmpm{}, SuddenCantilever<LockingLaw>(s.beam, cells), Flip{}, cells, s.common);
    });
    return a;
}

}  // namespace mpm
