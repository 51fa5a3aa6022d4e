/// cpdi_segment: the manufactured unit segment (review 6.2.1) by CPDI-L2 (l2.hpp).
///   ./cpdi_segment --G 0.05 --ppc 2 --cells 8,16,32,64
#include "chapters/cpdi/line_program.hpp"
#include "chapters/mms/segment.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "cpdi_segment";
constexpr const char* purpose = "a manufactured vibration by CPDI-L2";

/// The segment with a cell beyond either end, whose nodes are held.
struct WalledSegment : Segment<false> {
    Lattice<1> lattice(int cells, int per_cell) const { return with_ends(Segment::lattice(cells, per_cell), true); }
    template <class Grid, class Field> void fix(Grid& grid, Field field, double) const {
        for (const int I : {0, 1, grid.size() - 2, grid.size() - 1}) (grid[I].*field)[0] = 0;
    }
    template <class Grid> Vec<1> held_force(const Grid& grid) const {
        return grid[0].f + grid[1].f + grid[grid.size() - 2].f + grid[grid.size() - 1].f;
    }
};

int run(int argc, char** argv) {
    Options options(program, purpose);
    WalledSegment segment;
    LineSettings s;
    s.common.cells = {64};
    s.common.cfl = 0.2;
    s.common.shape = DomainL2::name;
    s.declare(options);
    segment.declare(options);
    s.common.declare(options, {DomainL2::name}, segment.period(), traits_of(segment));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    segment.check();
    if (segment.placing == "gauss") throw BadInput("--points gauss: domains lie around their particles, allowed: mid");
    if (!options.given("t-end")) s.common.t_end = segment.period();
    s.common = s.common.with_period(segment.period());
    const std::vector<std::string> columns(segment.columns.begin(), segment.columns.end());
    const Description about{program, purpose, segment.name, segment.solves, columns, segment.period()};
    return run_program(about, options, s.common, [&](int cells) { return assemble_line(segment, s, cells); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
