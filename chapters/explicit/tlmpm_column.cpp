/// tlmpm_column: a column in one dimension by the total-Lagrangian MPM (tlmpm.hpp), the three verification cases of the report "A Dynamic
/// Explicit Total Lagrangian MPM for Large Deformation in 1D": slow compression (A), a step load (B), energy (C).
///   ./tlmpm_column --case C --transfer fmpm --order 8
#include "chapters/explicit/tlmpm_column/settings.hpp"
#include "chapters/scenes/column_defaults.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "tlmpm_column";
constexpr const char* purpose = "a column by the total-Lagrangian MPM: compressed slowly, under a step load, with an initial energy";

void declare(Options& options, ColumnSettings& s) {
    s.column.declare(options);
    s.transfer.declare(options);
    options.choice("stress", s.scheme.stress, {"musl", "usl"}, "velocities of the stress update: mapped twice (musl) or not (usl)");
    options.choice("position", s.position, {"grid", "particle"},
                   "what moves particles: the grid's velocity, or their own as in the report's line 29");
    s.common.declare(options, ColumnShapes::names(), s.common.t_end, {.period = true});
}

/// What the options, each by itself allowed, cannot do together. Throws BadInput.
void check(const ColumnSettings& s) {
    s.column.check();
    s.transfer.check(s.common.ppc);
    const std::string &shape = s.common.shape, &transfer = s.transfer.name;
    const bool lagrange = shape == Lagrange2::name, two_nodes = lagrange || shape == Bernstein::name;
    if (s.position == "particle" && transfer != "flip") throw BadInput("--position particle: only --transfer flip has it, not " + transfer);
    if (lagrange && s.common.ppc < 2)
        throw BadInput("--ppc 1 with --shape lagrange: one particle leaves the nodes at the ends of its cell without mass; allowed >= 2");
    if (lagrange && transfer == "apic")
        throw BadInput("--transfer apic with --shape lagrange: its sums of phi (x_I - x_p)^2 are 0, since the functions reproduce squares");
    if (two_nodes && transfer == "consistent" && s.common.ppc < 3)
        throw BadInput("--ppc " + std::to_string(s.common.ppc) + " with --transfer consistent and --shape " + shape +
                       ": two nodes per cell need more particles for a mass matrix that is not singular; allowed >= 3");
}

/// The settings that a case has by default. The report's alpha = 0.5 (it mixes FLIP and PIC, and is no central difference) belongs to its
/// own transfer.
ColumnSettings of_case(const ColumnSettings& asked) {
    ColumnSettings s;
    s.column = column_case(asked.column.which);
    set_defaults(s.common, s.column);
    if (asked.transfer.name == "flip") s.transfer.alpha = 0.5;
    return s;
}

int run(int argc, char** argv) {
    ColumnSettings asked = of_case({});  // for its case and its transfer, on which the defaults depend
    Options first(program, purpose);
    declare(first, asked);
    first.parse(argc, argv);
    asked.column.name_case();
    ColumnSettings s = of_case(asked);
    Options options(program, purpose);
    s.column.which = ColumnCase().which;
    declare(options, s);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    s.column.name_case();
    check(s);
    const Description about{program, purpose, "column", s.column.solves(), s.column.columns(), 0, s.column.panels()};
    s.common = s.common.with_period(s.column.period());
    return run_program(about, options, s.common,
                       [&](int cells) { return s.column.law == Hooke::name ? hooke_column(s, cells) : neo_hookean_column(s, cells); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
