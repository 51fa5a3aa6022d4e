#include "chapters/cpdi/line_program.hpp"
#include "examples/contrast_bar/settings.hpp"

namespace mpm {

/// The bar with a cell beyond its wall, both of whose nodes are held.
struct WalledContrastBar : ContrastBar<false> {
    Lattice<1> lattice(int cells, int per_cell) const { return with_ends(ContrastBar::lattice(cells, per_cell), false); }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        for (const int I : {0, 1}) (grid[I].*field)[0] = 0;
    }
    template <class Grid> Vec<1> held_force(const Grid& grid) const { return grid[0].f + grid[1].f; }
};

Assembled cpdi_contrast(const ContrastSettings& s, int cells) {
    LineSettings line;
    line.common = s.common;
    return assemble_line(WalledContrastBar{s.scene}, line, cells);
}

}  // namespace mpm
