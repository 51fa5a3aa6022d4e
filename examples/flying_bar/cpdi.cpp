#include "chapters/cpdi/line_program.hpp"
#include "examples/flying_bar/settings.hpp"

namespace mpm {

/// The bar with a cell beyond its wall: rounding may take a corner past it.
struct WalledFlyingBar : FlyingBar<false> {
    using FlyingBar<false>::FlyingBar;
    Lattice<1> lattice(int cells_across, int per_cell) const { return with_ends(FlyingBar::lattice(cells_across, per_cell), false); }
    struct Observer : FlyingBar<false>::Observer {};
};

Assembled cpdi_flying(const FlyingSettings& s, int cells) {
    LineSettings line;
    line.common = s.common;
    return assemble_line(WalledFlyingBar(s.scene, cells), line, cells);
}

}  // namespace mpm
