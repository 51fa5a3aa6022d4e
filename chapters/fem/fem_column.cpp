/// fem_column: the column of tlmpm_column by total-Lagrangian explicit finite elements (total.hpp), its reference: the same cases, options
/// and files.
///   ./fem_column --case A --damping 0.1
#include "chapters/fem/total.hpp"
#include "chapters/scenes/column_defaults.hpp"
#include "chapters/weighting/assemble_with.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "fem_column";
constexpr const char* purpose = "a column by explicit finite elements: compressed slowly, under a step load, with an initial energy";

template <class Law>
Assembled elements(const ColumnCase& column, const Common& common, int cells) {
    Assembled a;
    ElementShapes::with(common.shape, [&](auto kernel) {
        a = assemble_with<decltype(kernel), true>(TotalFem{}, Column<Law>(column), NoTransfer{}, cells, common);
    });
    a.row.scene += "-" + column.which;
    return a;
}

/// Declares the options with the defaults of a case, and reads them.
void read(Options& options, ColumnCase& column, Common& common, const std::string& which, int argc, char** argv) {
    column = column_case(which);
    set_defaults(common, column);
    column.which = ColumnCase().which;
    column.declare(options);
    common.declare(options, ElementShapes::names(), common.t_end, {.period = true});
    options.parse(argc, argv);
    column.name_case();
}

int run(int argc, char** argv) {
    ColumnCase column;
    Common common;
    Options first(program, purpose), options(program, purpose);
    read(first, column, common, column.which, argc, argv);  // for the case, on which the defaults depend
    read(options, column, common, column.which, argc, argv);
    if (answered(options, program)) return 0;
    column.check();
    column.placing = "gauss";
    if (common.shape == Lagrange2::name && common.ppc < 2)
        throw BadInput("--ppc 1: one point leaves the end nodes of quadratic elements (--shape lagrange) without mass; allowed >= 2");
    const Description about{program, purpose, "column", column.solves(), column.columns(), 0, column.panels()};
    common = common.with_period(column.period());
    return run_program(about, options, common, [&](int cells) {
        return column.law == Hooke::name ? elements<Hooke>(column, common, cells) : elements<NeoHookean>(column, common, cells);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
