/// cpdi_bar: axial vibration of a bar (review 6.1.1) by CPDI-L2 (l2.hpp).
///   ./cpdi_bar --corners F
#include "chapters/cpdi/line_program.hpp"
#include "chapters/scenes/bar.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "cpdi_bar";
constexpr const char* purpose = "axial vibration of a bar by CPDI-L2";

/// The bar with a cell beyond its wall, both of whose nodes are held.
struct WalledBar : Bar<false> {
    Lattice<1> lattice(int cells, int per_cell) const { return with_ends(Bar::lattice(cells, per_cell), false); }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        for (const int I : {0, 1}) (grid[I].*field)[0] = 0;
    }
    template <class Grid> Vec<1> held_force(const Grid& grid) const { return grid[0].f + grid[1].f; }
};

int run(int argc, char** argv) {
    Options options(program, purpose);
    WalledBar bar;
    LineSettings s;
    s.common.shape = DomainL2::name;
    s.declare(options);
    bar.declare(options);
    s.common.declare(options, {DomainL2::name}, bar.default_t_end(), traits_of(bar));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    s.common = s.common.with_period(bar.period());
    const Description about{program, purpose, bar.name, bar.solves, {bar.columns.begin(), bar.columns.end()}, bar.period()};
    return run_program(about, options, s.common, [&](int cells) { return assemble_line(bar, s, cells); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
