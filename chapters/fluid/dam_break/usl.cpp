#include "chapters/explicit/usl.hpp"

#include "chapters/explicit/flip.hpp"
#include "chapters/fluid/dam_break/settings.hpp"
#include "chapters/weighting/assemble_with.hpp"

namespace mpm {

Assembled usl_dam(const DamBreakSettings& s, int cells) {
    return assemble_with<Hat, false>(Usl{s.cutoff}, DamBreak(s.dam, cells), Flip{s.alpha}, cells, s.common);
}

}  // namespace mpm
