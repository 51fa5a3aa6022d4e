#include "chapters/explicit/musl.hpp"

#include "chapters/explicit/flip.hpp"
#include "chapters/fluid/dam_break/settings.hpp"
#include "chapters/weighting/assemble_with.hpp"

namespace mpm {

Assembled musl_dam(const DamBreakSettings& s, int cells) {
    Assembled a;
    ShapeList<Hat, Ugimp, Cubic>::with(s.common.shape, [&](auto kernel) {
        a = assemble_with<decltype(kernel), false>(Musl{}, DamBreak(s.dam, cells), Flip{s.alpha}, cells, s.common);
    });
    return a;
}

}  // namespace mpm
