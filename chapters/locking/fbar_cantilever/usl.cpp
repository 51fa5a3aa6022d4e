#include "chapters/explicit/usl.hpp"

#include "chapters/explicit/flip.hpp"
#include "chapters/locking/fbar_cantilever/settings.hpp"
#include "chapters/weighting/assemble_with.hpp"

namespace mpm {

Assembled usl_cantilever(const FbarCantileverSettings& s, int cells) {
    Assembled a;
    ShapeList<Hat>::with(s.common.shape, [&](auto kernel) {
        a = assemble_with<decltype(kernel), false>(Usl{}, SuddenCantilever<LockingLaw>(s.beam, cells), Flip{}, cells, s.common);
    });
    return a;
}

}  // namespace mpm
