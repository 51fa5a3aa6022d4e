/// resting_column: the column of implicit_column, which sinks under its weight and a load until it rests, by explicit schemes with local
/// damping.
///   ./resting_column --cells 10,20,40
///   ./resting_column --stiffer 1e4 --ramp 1 --scheme musl
#include "examples/resting_column/settings.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "resting_column";
constexpr const char* purpose = "a column comes to rest under weight and load by explicit schemes with local damping";

int run(int argc, char** argv) {
    Options options(program, purpose);
    RestingColumnSettings s;
    s.common.cells = {20};
    s.common.ppc = 2;
    s.common.cfl = 0.5;
    options.choice("scheme", s.scheme, {"tlmpm", "musl"}, "method");
    options.number("damping", s.damping, "-", {.low = 0, .high = 1, .high_open = true},
                   "local damping: part of each node's force that opposes its velocity");
    s.column.declare(options);
    s.common.declare(options, {"hat", "cubic"}, 2, traits_of(s.column));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    s.column.at_rest();
    const auto& column = s.column;
    const Description about{program, purpose, column.name, column.solves, {column.columns.begin(), column.columns.end()}};
    return run_program(about, options, s.common, [&](int cells) {
        return s.scheme == "musl" ? musl_resting_column(s, cells) : tlmpm_resting_column(s, cells);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
