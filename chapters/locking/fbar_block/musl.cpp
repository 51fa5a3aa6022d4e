#include "chapters/explicit/musl.hpp"

#include "chapters/explicit/flip.hpp"
#include "chapters/locking/fbar_block/settings.hpp"
#include "chapters/weighting/assemble_with.hpp"

namespace mpm {

Assembled musl_block(const FbarBlockSettings& s, int cells) {
    Assembled a;
    ShapeList<Hat, Ugimp>::with(s.common.shape, [&](auto kernel) {
        a = assemble_with<decltype(kernel), false>(Musl{}, Cook<Fbar<NeoHookean>>(s.cook, cells, s.common.ppc), Flip{}, cells, s.common);
    });
    return a;
}

}  // namespace mpm
