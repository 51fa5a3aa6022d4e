#include "chapters/explicit/musl.hpp"

#include "chapters/explicit/flip.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "examples/resting_column/settings.hpp"

namespace mpm {

Assembled musl_resting_column(const RestingColumnSettings& s, int cells) {
    Assembled a;
    ShapeList<Hat, Cubic>::with(s.common.shape, [&](auto kernel) {
        const LoadedColumn<false> column(s.column, s.damping);
        a = assemble_with<decltype(kernel), false>(Musl{}, column, Flip{}, cells, s.common);
    });
    return a;
}

}  // namespace mpm
