#include "chapters/explicit/tlmpm.hpp"

#include "chapters/explicit/flip.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "examples/resting_column/settings.hpp"

namespace mpm {

Assembled tlmpm_resting_column(const RestingColumnSettings& s, int cells) {
    Assembled a;
    ShapeList<Hat, Cubic>::with(s.common.shape, [&](auto kernel) {
        const LoadedColumn<true> column(s.column, s.damping);
        a = assemble_with<decltype(kernel), true>(Tlmpm{}, column, Flip{}, cells, s.common);
    });
    return a;
}

}  // namespace mpm
